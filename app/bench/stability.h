#pragma once
// The suite `burl bench stability`: how far every way to fill a texture is from its definition
// where rounding has the most room, as a share of what docs/reference/numerics.md allows, with the
// input that comes nearest to it and the command that repeats it.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/bench/stability_cases.h"
#include "app/bench/stability_ways.h"

namespace burl {

struct StabilityRow {
    std::string group{}, arithmetic{};
    std::size_t cases = 0, values = 0;  ///< inputs, and texels or numbers that were looked at
    double share = 0.0;                 ///< worst error over the error allowed: 1 or less is right
    double error = 0.0;                 ///< the error there
    double largest = 0.0;               ///< of all errors
    double rms = 0.0;  ///< root mean square of the errors, the worst case's; of one case: 0
    std::string largest_case{}, rms_case{};
    double squares = 0.0;
    /// Worst shares of two bounds: a step from texel to texel against the step of the definition,
    /// and the two sides of a seam.
    double jump_share = 0.0, seam_share = 0.0;
    std::string input{};      ///< where the worst error is
    std::string case_name{};  ///< what `--case` takes; empty where a row counts failures

    /// A value more; `text()` says where it is, if it is the worst so far. NaN is worse than any.
    template <class Text>
    void note(double value_error, double allowed, const Text& text) {
        ++values;
        largest = std::max(largest, value_error), squares += value_error * value_error;
        const double its_share = value_error == 0.0 ? 0.0 : value_error / allowed;
        if (its_share <= share && !input.empty()) return;
        share = std::isnan(its_share) ? HUGE_VAL : its_share;
        error = value_error, input = text();
    }
    /// A number more that is right or not; rows of such count failures.
    template <class Text>
    void count(bool fails, const Text& text) {
        ++values;
        if (!fails) return;
        share += 1.0, error += 1.0;
        if (input.empty()) input = text();
    }
    /// Takes another row's numbers in, and where it is worse its input.
    void merge(const StabilityRow& other, const std::string& name);
};

/// Groups of texels against the definition in long double, by every way and arithmetic there is;
/// filtered colours against theirs; then what must not change a bit or must be refused, whose rows
/// count failures.
std::vector<StabilityRow> bench_stability(StabilityChoice choice);
/// Its first and its second part.
std::vector<StabilityRow> stability_errors(StabilityChoice choice);
std::vector<StabilityRow> stability_counts(StabilityChoice choice);

/// One case's texels, as a way filled them, against the definition.
StabilityRow field_errors(const StabilityCase& one, const StabilityWay& way,
                          const std::vector<double>& texels);

/// As field_errors for every way that knows the texture, in their order; with steps and seams.
std::vector<StabilityRow> case_errors(const StabilityCase& one);

/// The case that a row names, such as "coordinates/117" of the same choice. Throws Error(usage) if
/// there is none.
StabilityCase stability_case(const std::string& name, StabilityChoice choice);

}  // namespace burl
