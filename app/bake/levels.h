#pragma once
// The MIP levels that `burl bake` writes: how many were asked for, and their images.
#include <cstdint>
#include <string>
#include <vector>

#include "app/export/export.h"
#include "app/pipeline/pipeline.h"

namespace burl {

/// Which levels, and how they come about.
struct LevelsAsked {
    std::uint32_t count = 0;  ///< 0: none
    LevelRule rule{};
};

/// `text` is empty (none), a number or "all" (down to 1 x 1 of a texture of `size` texels a side);
/// more than there are become all. Files of float images hold all levels or none. A rule's name
/// (app/pipeline/direct_levels.h) instead of "all" means all by that rule; or else `rule` names it,
/// which may be empty. Throws Error(usage).
LevelsAsked levels_asked(const std::string& text, const std::string& rule, std::uint32_t size,
                         ImageKind kind);

BakedImage convert_to(Image<RgbF> image, ImageKind kind);

/// How many of the levels asked for a bake of the pipeline's recipe has: strip atlases have as many
/// as last_level says, more are said on stderr to be missing (in float images, to be mixtures).
std::uint32_t levels_there_are(Pipeline& pipeline, const LevelsAsked& asked, ImageKind kind);

/// Those of the texture, which is in linear light.
std::vector<BakedImage> bake_levels(Pipeline& pipeline, const Image<RgbF>& texture,
                                    const LevelsAsked& asked, ImageKind kind);

std::vector<BakedImage> convert_to(std::vector<Image<RgbF>> levels, ImageKind kind);

}  // namespace burl
