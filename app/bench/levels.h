#pragma once
// The suite `burl bench levels`: MIP levels by every rule (app/pipeline/direct_levels.h), how far
// each is from the surface's mean and what it costs to have that level and no other.
#include <string>
#include <vector>

#include "app/bench/result.h"
#include "app/bench/synthesis.h"

namespace burl {

struct LevelBench {
    std::string recipe;
    std::uint32_t level = 0;
    std::string rule;          ///< of level_rule_named
    double samples = 0.0;      ///< texels worked out, over those of level 0
    double rmse = 0.0;         ///< lookups against the surface's mean (docs/reference/metrics.md)
    double truth_noise = 0.0;  ///< RMS error of that mean
    double of_average = 1.0;   ///< rmse over that of the averaged level
    /// One thread, from points to the level's image; its group is recipe and level, where the first
    /// is level 0 averaged.
    BenchRow time{};
};

/// Levels 1 to 5 of each recipe's texture, `points` lookups each, `repeats` paired rounds. Mesh,
/// layout and spans are ready before the clock starts.
std::vector<LevelBench> bench_levels(int repeats, SynthesisSubjects subjects,
                                     std::size_t points = 10000);

}  // namespace burl
