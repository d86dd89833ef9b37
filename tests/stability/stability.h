#pragma once
// The suite `burl bench stability`: the errors of every way to fill a texture against its
// definition, for inputs where rounding errors are largest, as a share of the bounds of
// docs/reference/numerics.md, with the worst input and the command that reproduces it.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/stability/cases.h"
#include "tests/stability/ways.h"

namespace burl {

/// The errors of a group of cases in one arithmetic.
struct StabilityRow {
    std::string group{}, arithmetic{};
    std::size_t cases = 0, values = 0;  ///< number of inputs, and of texels or numbers compared
    /// Largest ratio of an error to its bound: at most 1 where the bound holds.
    double share = 0.0;
    double error = 0.0;    ///< error with that ratio
    double largest = 0.0;  ///< largest of all errors
    double rms = 0.0;      ///< largest RMS error of a case; 0 in the row of a single case
    /// The cases with the largest error and the largest RMS error.
    std::string largest_case{}, rms_case{};
    double squares = 0.0;  ///< sum of the squared errors
    /// Largest ratios to the bound for the difference of neighbouring texels from the definition's,
    /// and for the difference of the two sides of a seam.
    double jump_share = 0.0, seam_share = 0.0;
    std::string input{};      ///< input with the largest ratio
    std::string case_name{};  ///< argument of `--case`; empty in rows that count failures

    /// Adds an error and its bound; `text()` describes the input, and is called if the ratio is the
    /// largest so far. NaN is larger than any ratio.
    template <class Text>
    void note(double value_error, double allowed, const Text& text) {
        ++values;
        largest = std::max(largest, value_error), squares += value_error * value_error;
        const double its_share = value_error == 0.0 ? 0.0 : value_error / allowed;
        if (its_share <= share && !input.empty()) return;
        share = std::isnan(its_share) ? HUGE_VAL : its_share;
        error = value_error, input = text();
    }
    /// Adds a check that may have failed; in rows of checks, `share` and `error` count failures.
    template <class Text>
    void count(bool fails, const Text& text) {
        ++values;
        if (!fails) return;
        share += 1.0, error += 1.0;
        if (input.empty()) input = text();
    }
    /// Adds the numbers of the row of the case `name`, and its input where its ratio is larger.
    void merge(const StabilityRow& other, const std::string& name);
};

/// Runs the suite: the errors of all groups, in every way and arithmetic, against the definition in
/// long double; the errors of filtered colours; and checks of bit-exactness and of refusals, whose
/// rows count failures.
std::vector<StabilityRow> bench_stability(StabilityChoice choice);
/// Return the rows of errors, and the rows of checks.
std::vector<StabilityRow> stability_errors(StabilityChoice choice);
std::vector<StabilityRow> stability_counts(StabilityChoice choice);

/// Returns the errors of a case's texels, filled by a way.
StabilityRow field_errors(const StabilityCase& one, const StabilityWay& way,
                          const std::vector<double>& texels);

/// Returns the errors of every way that supports the texture, in the order of stability_ways(),
/// with steps and seams.
std::vector<StabilityRow> case_errors(const StabilityCase& one);

/// Returns the case that a row names, such as "coordinates/117" of the same choice. Throws
/// Error(usage) where there is none.
StabilityCase stability_case(const std::string& name, StabilityChoice choice);

}  // namespace burl
