#include "atlas/mesh_atlas.h"

#include <bit>

#include "atlas/error.h"

namespace burl {

const Atlas& MeshAtlas::atlas() const {
    if (const PatchAtlas* patched = patches()) return patched->atlas;
    return std::get<Atlas>(form_);
}

const Mesh& MeshAtlas::mesh(const Mesh& input) const {
    const PatchAtlas* patched = patches();
    return patched ? patched->refined.mesh : input;
}

MeshAtlas build_atlas(const Mesh& mesh, const Connectivity& connectivity,
                      const AtlasOptions& options) {
    if (options.kind != AtlasKind::patch)
        return MeshAtlas(layout_atlas(mesh, connectivity, options));
    check_size(options);
    if (auto patches = build_patch_atlas(mesh, connectivity, options))
        return MeshAtlas(std::move(*patches));
    AtlasOptions pairs = options;
    pairs.kind = std::has_single_bit(options.size) ? AtlasKind::quad : AtlasKind::area;
    return MeshAtlas(layout_atlas(mesh, connectivity, pairs));
}

SolidAtlas rasterize(const Mesh& input, const MeshAtlas& atlas, std::span<const Vec3d> positions) {
    if (const PatchAtlas* patches = atlas.patches()) return rasterize_patches(*patches, positions);
    return rasterize(input, atlas.atlas(), positions);
}

}  // namespace burl
