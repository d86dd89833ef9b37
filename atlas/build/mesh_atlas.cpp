#include "atlas/build/mesh_atlas.h"

#include <bit>
#include <utility>

#include <fmt/format.h>

#include "atlas/base/memory.h"
#include "atlas/build/capacity.h"
#include "atlas/outline/layout.h"
#include "atlas/outline/raster.h"
#include "atlas/read/pose.h"
#include "atlas/uv/layout.h"
#include "atlas/uv/raster.h"

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
    if (options.kind == AtlasKind::uv) return MeshAtlas(layout_uvs(mesh, connectivity, options));
    if (options.kind != AtlasKind::patch && options.kind != AtlasKind::chart)
        return MeshAtlas(layout_atlas(mesh, connectivity, options));
    check_size(options);
    const std::string no_patches = why_no_patches(connectivity, options);
    if (!no_patches.empty())
        return MeshAtlas(layout_pairs(mesh, connectivity, options, no_patches));
    const bool charts = options.kind == AtlasKind::chart;
    if (charts) {
        if (auto atlas = layout_charts(mesh, connectivity, options, stop))
            return MeshAtlas(std::move(*atlas));
    } else if (auto patches = build_patch_atlas(mesh, connectivity, options, stop)) {
        return MeshAtlas(std::move(*patches));
    }
    if (stop.stop_requested()) return std::nullopt;
    return MeshAtlas(layout_pairs(mesh, connectivity, options,
                                  fmt::format("the {0} do not fit {1} x {1} texels",
                                              charts ? "charts" : "patches", options.size)));
}

SolidAtlas rasterized(const Mesh& input, const MeshAtlas& atlas, std::span<const Vec3d> positions) {
    if (const PatchAtlas* patches = atlas.patches()) return rasterize_patches(*patches, positions);
    const Atlas& own = atlas.atlas();
    if (own.options.kind == AtlasKind::chart) return rasterize_charts(input, own, positions);
    return own.options.kind == AtlasKind::uv ? rasterize_uv_charts(input, own, positions)
                                             : rasterize(input, own, positions);
}

/// Appends to `result` a corner half-way between two corners of the pose, or at one of them (a ==
/// b).
void append_corner(const MeshPose& pose, std::size_t a, std::size_t b, MeshPose& result) {
    const Vec3d &p = pose.positions[a], &q = pose.positions[b];
    result.positions.push_back(a == b ? p : 0.5 * p + 0.5 * q);
    if (pose.normals.empty()) return;
    const Vec3f n = pose.normals[a];
    result.normals.push_back(a == b ? n : n + pose.normals[b]);
}

/// The input mesh's corner (3 face + k) at which the face has the point; the k-th if the face has
/// the point twice and that corner is one of them.
std::uint32_t corner_at(const Mesh& mesh, std::uint32_t face, std::uint32_t point, std::size_t k) {
    const Triangle& triangle = mesh.triangles[face];
    const std::uint32_t first = 3 * face;
    if (triangle[k] == point) return first + std::uint32_t(k);
    return triangle[0] == point ? first : triangle[1] == point ? first + 1 : first + 2;
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
    SolidAtlas solid = rasterized(input, atlas, positions);
    if (input.triangles.size() > many_triangles) return_freed_memory();
    return solid;
}

std::vector<CornerOrigin> corner_origins(const Mesh& input, const MeshAtlas& atlas) {
    std::vector<CornerOrigin> origins;
    const PatchAtlas* patches = atlas.patches();
    if (!patches) {
        origins.reserve(3 * input.triangles.size());
        for (std::uint32_t c = 0; c < 3 * input.triangles.size(); ++c) origins.push_back({c, c});
        return origins;
    }
    const RefinedMesh& refined = patches->refined;
    const std::size_t count = refined.mesh.triangles.size();
    origins.reserve(3 * count);
    auto cut = refined.cut_faces.begin();
    std::uint32_t face = 0;
    for (std::size_t t = 0; t < count; ++face) {
        const bool is_cut = cut != refined.cut_faces.end() && cut->face == face;
        const std::size_t end = t + (is_cut ? cut->pieces : 1);
        if (is_cut) ++cut;
        for (; t < end; ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const VertexOrigin origin = refined.origin(refined.mesh.triangles[t][k]);
                origins.push_back(
                    {corner_at(input, face, origin.a, k), corner_at(input, face, origin.b, k)});
            }
    }
    return origins;
}

MeshPose atlas_pose(const MeshPose& pose, const Mesh& input, const MeshAtlas& atlas) {
    check_pose(pose, input);
    if (!atlas.patches()) return pose;
    const std::vector<CornerOrigin> origins = corner_origins(input, atlas);
    MeshPose result{pose.name, {}};
    result.positions.reserve(origins.size());
    for (const auto& [a, b] : origins) append_corner(pose, a, b, result);
    return result;
}

}  // namespace burl
