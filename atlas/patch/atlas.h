#pragma once
// The patch atlas: few patches on full rectangles, so that its texture can be minified with plain
// bilinear and trilinear lookups. Several partitions are tried and the one with the least predicted
// stretch is kept; then every map is fitted again to the proportions that its block really got. The
// top of atlas.cpp lists the steps in order.
#include <optional>
#include <span>
#include <stop_token>

#include "atlas/patch/candidates.h"
#include "atlas/patch/maps.h"
#include "atlas/patch/refine.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

/// A triangle with its corners' places in the texture, in texels.
struct PlacedTriangle {
    Triangle points{};  ///< points of the refined mesh, or hubs numbered behind them
    std::array<Vec2d, 3> places{};
};

/// The data of a patch that rasterising needs besides the patch's triangles.
struct PlacedPatch {
    /// A triangle of the refined mesh, to which the block's texels belong that show none.
    std::uint32_t triangle = 0;
    /// Three points far apart, of a planar patch only.
    std::optional<PlacedTriangle> plane{};
    std::vector<PlacedTriangle> fans{};  ///< triangles that close holes; no part of the mesh
};

/// A patch atlas. It holds 90 bytes a triangle, most of them in the corners of the charts (Atlas).
struct PatchAtlas {
    RefinedMesh refined;  ///< exported mesh: the mesh with the middles of chords
    Atlas atlas;          ///< corners and charts of the refined mesh's triangles; no blocks
    PatchLayout layout;
    std::vector<PlacedPatch> patches;
    std::uint32_t hubs = 0;  ///< hubs: centres of closed holes, which are no mesh points
    PatchMapNotes notes;
    std::size_t unmapped = 0;  ///< triangles for which no map was found
    int candidates = 0;        ///< divisions into patches that were judged

    /// The patch of a triangle of the refined mesh; not_in_mesh for one without a map, which has a
    /// chart of its own behind the patches' charts.
    std::uint32_t patch_of(std::size_t triangle) const {
        const std::uint32_t chart = atlas.charts[triangle];
        return chart < patches.size() ? chart : not_in_mesh;
    }
};

/// The best division of the mesh into patches for the texture, each patch with the map that suits
/// its block. Nothing when the texture cannot hold the patches, or when `stop` was requested first.
/// Only size and tries of the options matter.
std::optional<PatchCandidate> fit_patches(const Mesh& mesh, const Connectivity& connectivity,
                                          const AtlasOptions& options,
                                          const std::stop_token& stop = {});

/// The atlas of the fitted patches. A triangle for which no map was found (it has no area) lies at
/// the place of its first point in a patch, or, where that has none, at texel (0,0).
PatchAtlas place_patches(const Mesh& mesh, const PatchCandidate& fitted,
                         const AtlasOptions& options);

/// fit_patches(), then place_patches(). Pure and deterministic.
std::optional<PatchAtlas> build_patch_atlas(const Mesh& mesh, const Connectivity& connectivity,
                                            const AtlasOptions& options = {},
                                            const std::stop_token& stop = {});

/// The solid points of all texels. `positions` are the refined mesh's points in the space wanted.
/// Inner texels show the triangle at their centre; gutters show the surface that goes on beyond the
/// patch's border (block_gutters.h), around a planar patch as far as two gutters, and farther out
/// its plane. Spans name maps: those of the refined mesh's triangles come first, then those of
/// gutters, closed holes and planes.
SolidAtlas rasterize_patches(const PatchAtlas& atlas, std::span<const Vec3d> positions);

/// Gives the vertices of maps made in the unit frame the mesh's own positions, and planes, areas
/// and stretches its units. Inner places of rectangle maps stay as they are; planar patches are
/// projected anew.
void to_mesh_frame(PatchMaps& maps, const Mesh& mesh);

}  // namespace burl
