#pragma once
// The patch atlas: few patches on full rectangles, so that a texture of it can be minified with
// plain bilinear and trilinear lookups. Several partitions are tried and the one whose predicted
// stretch is least is kept; then every map is fitted again to the proportions its block really got.
#include <optional>
#include <span>
#include <stop_token>

#include "atlas/patch/candidates.h"
#include "atlas/patch/refine.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

/// Three points and their places in the texture, in texels.
struct PlacedTriangle {
    Triangle points{};  ///< of the refined mesh, or behind them a hub (PatchAtlas::hubs)
    std::array<Vec2d, 3> places{};
};

/// What rasterising needs of a patch besides its triangles.
struct PlacedPatch {
    std::uint32_t triangle = 0;  ///< of the refined mesh: who texels without one belong to
    std::optional<PlacedTriangle> plane{};  ///< of a planar patch: three points far apart
    std::vector<PlacedTriangle> fans{};     ///< close holes; no part of the mesh
};

/// Kept are 90 bytes a triangle, corners of the charts (Atlas) being most of them.
struct PatchAtlas {
    RefinedMesh refined;  ///< what is exported: the mesh with the middles of chords
    Atlas atlas;          ///< corners and charts of the refined mesh's triangles; no blocks
    PatchLayout layout;
    std::vector<PlacedPatch> patches;
    std::uint32_t hubs = 0;  ///< centres of closed holes: points with no number of their own
    PatchMapNotes notes;
    std::size_t unmapped = 0;  ///< triangles no map was found for
    int candidates = 0;        ///< divisions judged

    /// A refined triangle's patch, or not_in_mesh for one that no map was found for: it has a chart
    /// of its own, behind the patches'.
    std::uint32_t patch_of(std::size_t triangle) const {
        const std::uint32_t chart = atlas.charts[triangle];
        return chart < patches.size() ? chart : not_in_mesh;
    }
};

/// The division into patches that is best for the texture, each with the map that suits its block.
/// Nothing when the texture cannot hold the patches, or when `stop` came first. Of the options,
/// size and tries matter.
std::optional<PatchCandidate> fit_patches(const Mesh& mesh, const Connectivity& connectivity,
                                          const AtlasOptions& options,
                                          const std::stop_token& stop = {});

/// Places the triangles of the patches; those that no map was found for (they have no area) on a
/// point of their own patch neighbours, or at texel (0,0).
PatchAtlas place_patches(const Mesh& mesh, const PatchCandidate& fitted,
                         const AtlasOptions& options);

/// Both. Pure and deterministic.
std::optional<PatchAtlas> build_patch_atlas(const Mesh& mesh, const Connectivity& connectivity,
                                            const AtlasOptions& options = {},
                                            const std::stop_token& stop = {});

/// The solid points of all texels. `positions` are the refined mesh's points in the space wanted.
/// Inner texels show the triangle at their centre; gutters continue the block by odd reflection,
/// s(-k) = 2 s(0) - s(k), a planar patch's block by its plane. Spans name maps: those of the
/// refined mesh's triangles come first, then those of gutters, closed holes and planes.
SolidAtlas rasterize_patches(const PatchAtlas& atlas, std::span<const Vec3d> positions);

}  // namespace burl
