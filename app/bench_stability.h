#pragma once
// The suite `burl bench stability`: how far synthesis is from its definition where rounding has the
// most room, as a share of what docs/numerics.md allows, with the input that comes nearest to it.
#include <string>
#include <vector>

#include "app/stability_cases.h"
#include "atlas/image.h"

namespace burl {

struct StabilityRow {
    std::string group{};
    std::size_t cases = 0, values = 0;  ///< inputs, and texels or numbers that were looked at
    double share = 0.0;                 ///< worst error over the error allowed: 1 or less is right
    double error = 0.0;                 ///< the error there
    std::string input{};                ///< where that is
};

/// Groups of texels against the definition in long double, then what must not change a bit, what
/// must not jump, and what must be refused; of these three, share and error count failures.
/// `full`: some 10 s and 1 GB; otherwise a thinned choice.
std::vector<StabilityRow> bench_stability(bool full);

/// One case's texels, as they were synthesised, against the definition.
StabilityRow field_errors(const StabilityCase& one, const Image<float>& field);

}  // namespace burl
