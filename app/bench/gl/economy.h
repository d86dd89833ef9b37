#pragma once
// The parts of `burl bench economy` without cameras: the cost of an edit of a recipe with cached
// intermediate values, and the octaves that the band limit leaves out.
#include <cstdint>
#include <string>
#include <vector>

#include "app/bench/bench.h"
#include "procedural/batch/economy.h"

namespace burl {

/// An edit by a slider, in a program that shows the texture (Pipeline::picture).
struct EditBench {
    BenchRow time;         ///< times_first is relative to the whole texture
    SynthesisWork work{};  ///< work of one edit
};

/// Measures edits of marble with its four octaves as separate terms, on a torus with `size` x
/// `size` texels: the whole texture, and changes of a colour, of one term's amplitude, of its
/// phase, and of the camera alone, each case dragging one slider. All threads; `repeats` paired
/// rounds.
std::vector<EditBench> bench_edits(int repeats, std::uint32_t size);

/// The octaves left out by one synthesis.
struct SparedOctaves {
    std::string recipe;
    std::uint32_t level = 0;  ///< MIP level of the texture
    SynthesisWork work{};
    double share(Skip skip) const;  ///< share of all octaves to be evaluated
};

/// The octaves left out of level `level` of the recipe's texture on the teapot, synthesised on its
/// own, where every texel fades out the octaves it cannot show (filter.octaves fade).
SparedOctaves spared_by_band_limit(const std::string& recipe, std::uint32_t size,
                                   std::uint32_t level);

}  // namespace burl
