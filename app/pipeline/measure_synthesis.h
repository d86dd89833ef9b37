#pragma once
// Timing of a recipe's synthesis on this machine, by the host and by another synthesizer.
#include <functional>

#include "app/pipeline/texture_synthesizer.h"

namespace burl {

/// Seconds to synthesise one texture of 8 bits per channel into host memory.
struct SynthesisSeconds {
    double host = 0.0, other = 0.0;
};

/// Times both ways on a square of `side` x `side` texels near the middle plane of the unit cube
/// around the origin, on all threads: one run to warm up (shaders, tables and maps are made), then
/// the least of three runs. synthesizer.problem(recipe) must be empty; forget_atlas() is called at
/// the end.
SynthesisSeconds measure_synthesis(TextureSynthesizer& synthesizer, const Recipe& recipe,
                                   std::uint32_t side = 1024);

/// Times the host's way and another, which fills the texture of the square.
SynthesisSeconds measure_synthesis(const Recipe& recipe,
                                   const std::function<void(const SolidAtlas& square)>& other,
                                   std::uint32_t side = 1024);

}  // namespace burl
