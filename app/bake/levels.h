#pragma once
// The MIP levels that `burl bake` writes: the option's value, and their images.
#include <cstdint>
#include <string>
#include <vector>

#include "app/export/export.h"
#include "app/pipeline/pipeline.h"

namespace burl {

/// The number of MIP levels above level 0, and their rule.
struct LevelsAsked {
    std::uint32_t count = 0;  ///< number of levels; 0: none
    LevelRule rule{};
};

/// Parses --levels and --level-rule. `text` is empty (no levels), a number, "all" (down to 1 x 1
/// for a texture of `size` texels a side) or the name of a rule (app/pipeline/direct_levels.h),
/// which means all levels by that rule. Too large numbers mean all; for float images any number but
/// 0 does, since their files hold all levels or none. `rule` names the rule otherwise; empty:
/// average. Throws Error(usage).
LevelsAsked levels_asked(const std::string& text, const std::string& rule, std::uint32_t size,
                         ImageKind kind);

/// The image, which is in linear light, as an image of `kind`.
BakedImage convert_to(Image<RgbF> image, ImageKind kind);

/// The number of levels that a bake of the pipeline's recipe writes. Strip atlases have at most
/// last_level levels; a warning on stderr says that more are left out, or, in float images, mix
/// unrelated triangles.
std::uint32_t levels_there_are(Pipeline& pipeline, const LevelsAsked& asked, ImageKind kind);

/// The levels 1, 2, ... of `texture`, which is in linear light, as images of `kind`.
std::vector<BakedImage> bake_levels(Pipeline& pipeline, const Image<RgbF>& texture,
                                    const LevelsAsked& asked, ImageKind kind);

/// The images, which are in linear light, as images of `kind`; each input is freed once it is
/// converted.
std::vector<BakedImage> convert_to(std::vector<Image<RgbF>> levels, ImageKind kind);

}  // namespace burl
