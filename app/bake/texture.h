#pragma once
// The texture of a bake with its MIP levels, in the kind of image that its file holds.
#include <vector>

#include "app/bake/levels.h"

namespace burl {

/// A texture and its MIP levels.
struct BakedTexture {
    BakedImage image{};
    std::vector<BakedImage> levels{};  ///< levels 1, 2, ...
};

/// Whether the texture and `levels` can be made without the whole float texture in memory.
bool comes_in_bands(Pipeline& pipeline, const LevelsAsked& levels);

/// The texture of the pipeline's recipe with `levels`, as images of `kind`.
BakedTexture bake_texture(Pipeline& pipeline, ImageKind kind, const LevelsAsked& levels);

}  // namespace burl
