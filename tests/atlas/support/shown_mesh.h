#pragma once
// A mesh in an atlas, for tests of masks at texels.
#include <cstdint>

#include "atlas/build/mesh_atlas.h"
#include "atlas/shape/surface_lattice.h"
#include "atlas/solid/texel_owners.h"

namespace burl {

struct Shown {
    Mesh mesh;
    Atlas atlas;
    SolidAtlas solid;
    ShapeScene shape;

    TexelOwners owners() const { return {solid, atlas, OwnerReach::gutters}; }
};

/// The mesh in an atlas of a kind, with texels in the mesh's own space.
inline Shown shown(const Mesh& input, AtlasKind kind, std::uint32_t size) {
    AtlasOptions options;
    options.kind = kind, options.size = size;
    const MeshAtlas atlas = build_atlas(input, build_connectivity(input), options);
    const Mesh& mesh = atlas.mesh(input);
    return {mesh, atlas.atlas(), rasterize(input, atlas, mesh.positions), ShapeScene(mesh)};
}

/// Calls visit(x, y, triangle, weights of its corners) for all texels that show something.
template <class Visit>
void for_texels(const Shown& all, const Visit& visit) {
    const TexelOwners owners = all.owners();
    for (std::uint32_t y = 0; y < all.solid.size; ++y)
        for (const Span& span : all.solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                const ShownPlace place = place_shown(all.solid, owners, all.shape, x, y, span.map);
                visit(x, y, place.triangle, place.weights);
            }
}

}  // namespace burl
