#pragma once
// The MIP levels that `burl bake` writes: how many were asked for, and their images.
#include <cstdint>
#include <string>
#include <vector>

#include "app/export.h"
#include "app/pipeline.h"

namespace burl {

/// `text` is empty (none), a number or "all" (down to 1 x 1 of a texture of `size` texels a side);
/// more than there are become all. Files of float images hold all levels or none. Throws
/// Error(usage).
std::uint32_t levels_asked(const std::string& text, std::uint32_t size, ImageKind kind);

BakedImage convert_to(Image<RgbF> image, ImageKind kind);

/// Levels 1 to `levels` of the texture, in linear light, converted. Strip atlases have as many as
/// last_level says: more are said on stderr to be missing (in float images, to be mixtures).
std::vector<BakedImage> bake_levels(Pipeline& pipeline, const Image<RgbF>& texture,
                                    std::uint32_t levels, ImageKind kind);

}  // namespace burl
