#include "atlas/build/mesh_atlas.h"

#include <bit>

#include <fmt/format.h>

#include "atlas/base/freed_memory.h"
#include "atlas/build/capacity.h"

namespace burl {

namespace {

/// A quad or area atlas in place of patches, for the reason `why`; see build_atlas().
Atlas layout_pairs(const Mesh& mesh, const Connectivity& connectivity, const AtlasOptions& options,
                   const std::string& why) {
    const std::uint32_t size = options.size, square = std::bit_floor(size);
    AtlasOptions pairs = options;
    pairs.kind = AtlasKind::area;
    const bool strips = 2 * std::uint64_t{square} * square < std::uint64_t{size} * size &&
                        smallest_size(mesh.triangles.size(), pairs) <= size;
    if (!strips) {
        pairs.kind = AtlasKind::quad;
        pairs.size = square;
    }
    Atlas atlas = layout_atlas(mesh, connectivity, pairs);
    atlas.options.size = size;
    atlas.notes.texels_total = std::uint64_t{size} * size;
    atlas.notes.fallback = fmt::format("{}: {} atlas instead", why, to_string(pairs.kind));
    if (!strips && square < size)
        atlas.notes.fallback += fmt::format(", in {0} x {0} of its texels", square);
    return atlas;
}

std::optional<MeshAtlas> pack(const Mesh& mesh, const Connectivity& connectivity,
                              const AtlasOptions& options, const std::stop_token& stop) {
    if (options.kind != AtlasKind::patch)
        return MeshAtlas(layout_atlas(mesh, connectivity, options));
    check_size(options);
    const std::string no_patches = why_no_patches(connectivity, options.size);
    if (!no_patches.empty())
        return MeshAtlas(layout_pairs(mesh, connectivity, options, no_patches));
    if (auto patches = build_patch_atlas(mesh, connectivity, options, stop))
        return MeshAtlas(std::move(*patches));
    if (stop.stop_requested()) return std::nullopt;
    return MeshAtlas(
        layout_pairs(mesh, connectivity, options,
                     fmt::format("the patches do not fit {0} x {0} texels", options.size)));
}

}  // namespace

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
    return *build_atlas(mesh, connectivity, options, {});
}

std::optional<MeshAtlas> build_atlas(const Mesh& mesh, const Connectivity& connectivity,
                                     const AtlasOptions& options, const std::stop_token& stop) {
    std::optional<MeshAtlas> atlas = pack(mesh, connectivity, options, stop);
    if (mesh.triangles.size() > many_triangles) return_freed_memory();
    return atlas;
}

SolidAtlas rasterize(const Mesh& input, const MeshAtlas& atlas, std::span<const Vec3d> positions) {
    const PatchAtlas* patches = atlas.patches();
    SolidAtlas solid = patches ? rasterize_patches(*patches, positions)
                               : rasterize(input, atlas.atlas(), positions);
    if (input.triangles.size() > many_triangles) return_freed_memory();
    return solid;
}

}  // namespace burl
