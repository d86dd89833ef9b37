#pragma once
// The patch atlas: few patches on full rectangles, so that a texture of it can be minified with
// plain bilinear and trilinear lookups. Several partitions are tried and the one whose predicted
// stretch is least is kept; then every map is fitted again to the proportions its block really got.
#include <span>
#include <stop_token>

#include "atlas/patch_layout.h"
#include "atlas/patch_refine.h"
#include "atlas/solid_atlas.h"

namespace burl {

struct PatchAtlas {
    RefinedMesh refined;  ///< what is exported: the mesh with the middles of chords
    Atlas atlas;          ///< corners and charts of the refined mesh's triangles; no blocks
    PatchMaps maps;
    PatchLayout layout;
    int candidates = 0;  ///< divisions judged
};

/// Pure and deterministic. Triangles that no map was found for (they have no area) are placed on a
/// point of their own patch neighbours, or at texel (0,0). Nothing when the texture cannot hold the
/// patches, or when `stop` came first. Of the options, size and tries matter.
std::optional<PatchAtlas> build_patch_atlas(const Mesh& mesh, const Connectivity& connectivity,
                                            const AtlasOptions& options = {},
                                            const std::stop_token& stop = {});

/// The solid points of all texels. `positions` are the refined mesh's points in the space wanted.
/// Inner texels show the triangle at their centre; gutters continue the block by odd reflection,
/// s(-k) = 2 s(0) - s(k), a planar patch's block by its plane. Spans name maps: those of the
/// refined mesh's triangles come first, then those of gutters, closed holes and planes.
SolidAtlas rasterize_patches(const PatchAtlas& atlas, std::span<const Vec3d> positions);

}  // namespace burl
