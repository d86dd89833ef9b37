#pragma once
// The texture of a bake in the kind of image that its file wants, with its MIP levels.
#include <vector>

#include "app/bake/levels.h"

namespace burl {

struct BakedTexture {
    BakedImage image{};
    std::vector<BakedImage> levels{};  ///< 1, 2, ...
};

/// Whether the texture and these levels of it, if any, can be had without the whole texture in
/// floats at a time.
bool comes_in_bands(Pipeline& pipeline, const LevelsAsked& levels);

/// Of the pipeline's recipe.
BakedTexture bake_texture(Pipeline& pipeline, ImageKind kind, const LevelsAsked& levels);

}  // namespace burl
