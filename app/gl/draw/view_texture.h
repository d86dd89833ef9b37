#pragma once
// The texture of a pipeline's recipe, of which only those texels are worked out that a view looks
// up: what the rest of the atlas shows, nobody sees.
#include <cstdint>
#include <vector>

#include "app/gl/draw/view_texels.h"
#include "app/pipeline/direct_levels.h"
#include "app/pipeline/fill_texture.h"
#include "app/scene/scene.h"

namespace burl {

/// What of an atlas was worked out for a view. Texels of level 0 and, where levels are direct, of
/// those that have samples of their own; only those in spans count.
struct ViewWork {
    std::uint64_t tiles = 0;         ///< pairs of 32 x 32 texels and a level that are looked up
    std::uint64_t texels_read = 0;   ///< looked up, or parts of means that are
    std::uint64_t texels_made = 0;   ///< those and the rest of their cells
    std::uint64_t texels_whole = 0;  ///< of the atlas, level 0 alone
    SynthesisWork synthesis{};       ///< of the colours
};

/// Texels are made in cells of so many a side. Cells of one take no longer than larger ones with
/// more texels in them (docs/lab/benchmarks.md).
inline constexpr std::uint32_t view_cell = 1;

/// The recipe's atlas, and how its texture's levels come about.
struct ViewSource {
    const MeshAtlas& layout;
    const SolidAtlas& solid;
    const Recipe& recipe;
    LevelRule rule{};

    /// Whose samples the texels of a level are means of. Levels that a bake does not write are
    /// averaged, by OpenGL.
    std::uint32_t source(std::uint32_t level) const;
    SolidAtlas level(std::uint32_t number) const;
};

/// Per level the texels that are worked out there (ViewTexels::beneath), with the rest of their
/// cells.
std::vector<TexelSet> view_part(const ViewSource& source, const ViewTexels& view,
                                std::uint32_t cell);
/// All of level 0, and what of other levels has samples.
std::vector<TexelSet> whole_part(const ViewSource& source);
/// Those in spans.
std::uint64_t count_texels(const ViewSource& source, const std::vector<TexelSet>& part);

/// Pixels and, where `filter` looks them up, levels of a baked scene's colours, as `burl bake
/// --levels all` writes them where levels are looked up, and as `burl bake` does otherwise. Texels
/// that are not in `part`, or of other levels not in `view`, hold anything, and levels that the
/// view does not read may be missing.
SceneTexture view_texture(const ViewSource& source, const std::vector<TexelSet>& part,
                          const ViewTexels& view, TextureFilter filter, const HostWay& way,
                          const Economy& economy = {});

/// The normals of the recipe's bumps in tangent space, of those texels of `mesh`, which is the one
/// that was laid out.
Image<Rgb8> view_normals(const ViewSource& source, const Mesh& mesh, const TexelSet& texels,
                         double crease_degrees, int threads);

}  // namespace burl
