#pragma once
// An atlas of whichever kind was asked for, with the mesh its corners belong to: the patch atlas
// splits a few triangles, the others take the mesh as it is.
#include <variant>

#include "atlas/patch_atlas.h"

namespace burl {

class MeshAtlas {
  public:
    explicit MeshAtlas(Atlas atlas) : form_(std::move(atlas)) {}
    explicit MeshAtlas(PatchAtlas patches) : form_(std::move(patches)) {}

    const Atlas& atlas() const;
    /// Nothing for the kinds made of blocks.
    const PatchAtlas* patches() const { return std::get_if<PatchAtlas>(&form_); }
    /// The mesh whose triangles the atlas places, given the one it was built from.
    const Mesh& mesh(const Mesh& input) const;

  private:
    std::variant<Atlas, PatchAtlas> form_;
};

/// Packs the mesh, as layout_atlas does for strips and quad. Where patches do not fit, pairs take
/// their place: quad, or area where the size is not a power of two; atlas().options.kind says so.
MeshAtlas build_atlas(const Mesh& mesh, const Connectivity& connectivity,
                      const AtlasOptions& options);

/// The solid points of all texels; `positions` are those of atlas.mesh(input) in the space wanted.
SolidAtlas rasterize(const Mesh& input, const MeshAtlas& atlas, std::span<const Vec3d> positions);

}  // namespace burl
