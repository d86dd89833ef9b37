#pragma once
// The parts of `burl bench economy` without cameras: what an edit of a recipe costs where results
// are kept, which octaves distance spares, and which an early exit does.
#include <cstdint>
#include <string>
#include <vector>

#include "app/bench/bench.h"
#include "procedural/batch/economy.h"

namespace burl {

/// A slider that was moved, in a program that shows the texture (Pipeline::picture).
struct EditBench {
    BenchRow time;         ///< times_first: over the whole texture's
    SynthesisWork work{};  ///< of one move
};

/// Marble's four octaves as terms of their own on a torus of `size` x `size` texels: the whole
/// texture, and after a move of its colours, of one term's amplitude, of its phase, and of the
/// camera alone, each as one of many moves of that slider. All threads; `repeats` paired rounds.
std::vector<EditBench> bench_edits(int repeats, std::uint32_t size);

/// Octaves that one synthesis left out.
struct SparedOctaves {
    std::string recipe;
    std::uint32_t level = 0;  ///< of the texture
    SynthesisWork work{};
    double share(Skip skip) const;  ///< of all octaves that it would have evaluated
};

/// What level `level` of the recipe's texture on the teapot leaves out when every texel shows only
/// the octaves it can (filter.octaves fade), and is made by itself.
SparedOctaves spared_by_band_limit(const std::string& recipe, std::uint32_t size,
                                   std::uint32_t level);

/// What the early exit leaves out of the texture of level 0.
SparedOctaves spared_by_early_exit(const std::string& recipe, std::uint32_t size);

}  // namespace burl
