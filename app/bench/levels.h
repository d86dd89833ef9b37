#pragma once
// The suite `burl bench levels`: MIP levels by every rule (app/pipeline/direct_levels.h), their
// errors against the mean over the surface, and the cost of one level alone.
#include <string>
#include <vector>

#include "app/bench/bench.h"
#include "app/bench/synthesis.h"

namespace burl {

/// The results of one rule at one level.
struct LevelBench {
    std::string recipe;
    std::uint32_t level = 0;
    std::string rule;      ///< name of the rule, for level_rule_named()
    double samples = 0.0;  ///< texels synthesised, as a multiple of those of level 0
    /// RMS error of lookups against the mean over the surface (docs/reference/metrics.md).
    double rmse = 0.0;
    double truth_noise = 0.0;  ///< RMS error of the reference, that mean
    double of_average = 1.0;   ///< rmse divided by that of the averaged level
    /// Time from solid points to the level's image, on one thread. The group is a recipe and level,
    /// and its first case is level 0 averaged down.
    BenchRow time{};
};

/// Measures levels 1 to 5 of each recipe's texture with `points` lookups each, in `repeats` paired
/// rounds. Mesh, layout and spans are not timed.
std::vector<LevelBench> bench_levels(int repeats, SynthesisSubjects subjects,
                                     std::size_t points = 10000);

}  // namespace burl
