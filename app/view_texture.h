#pragma once
// The texture of a pipeline's recipe, of which only those texels are worked out that a view looks
// up: what the rest of the atlas shows, nobody sees.
#include <optional>

#include "app/fill_texture.h"
#include "app/pipeline.h"
#include "app/view_texels.h"

namespace burl {

/// What of an atlas was worked out for a view.
struct ViewWork {
    std::uint64_t tiles = 0;         ///< pairs of 32 x 32 texels and a level that are looked up
    std::uint64_t texels_read = 0;   ///< of level 0 in spans: looked up, or parts of means that are
    std::uint64_t texels_made = 0;   ///< of level 0 in spans
    std::uint64_t texels_whole = 0;  ///< of all spans
};

/// Texels are made in cells of so many a side: single ones take up to twice as long each, and 32 x
/// 32 tiles hold more than a picture reads (docs/economy.md).
inline constexpr std::uint32_t view_cell = 8;

/// Texels of level 0 to be worked out: those in spans of the cells that the view reads.
SolidAtlas view_atlas(const SolidAtlas& solid, const ViewTexels& view, std::uint32_t cell);

ViewWork view_work(const SolidAtlas& solid, const SolidAtlas& part, const ViewTexels& view);

/// Pixels and, where `filter` looks them up, levels of a baked scene's colours, as `burl bake
/// --levels all` writes them where levels are looked up, and as `burl bake` does otherwise. Texels
/// that are in no span of `part` hold the background; so do means of such, and levels that the view
/// does not read may be missing.
SceneTexture view_texture(Pipeline& pipeline, const SolidAtlas& part, const ViewTexels& view,
                          TextureFilter filter, const HostWay& way);

}  // namespace burl
