#pragma once
// Which of two ways makes a recipe's texture faster here, the host's or another one's: by trying.
#include "app/pipeline/texture_synthesizer.h"

namespace burl {

/// Of one texture in 8 bits, to host memory.
struct SynthesisSeconds {
    double host = 0.0, other = 0.0;
};

/// Both ways on a square of `side` x `side` texels through the middle of the unit cube, on all
/// threads: once to warm up (shaders, tables and maps are made), then three times, of which the
/// least counts. `synthesizer` must be able to make the recipe (problem()); it forgets its atlas.
SynthesisSeconds measure_synthesis(TextureSynthesizer& synthesizer, const Recipe& recipe,
                                   std::uint32_t side = 1024);

}  // namespace burl
