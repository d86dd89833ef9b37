#include "tests/fuzz/sound_mesh.h"

#include <cmath>

#include "atlas/measure/atlas_measures.h"
#include "tests/fuzz/target.h"

namespace burl::fuzz {
namespace {

bool is_finite(const Vec2d& v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}

bool is_finite(const Vec3d& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool fits(std::size_t attributes, const Mesh& mesh) {
    return attributes == 0 || attributes == 3 * mesh.triangles.size();
}

void check_parts(const Mesh& mesh) {
    std::size_t next = 0;
    for (const Part& part : mesh.parts) {
        require(part.first_triangle == next, "parts cover the triangles in order");
        next += part.triangle_count;
        require(!part.instances.empty(), "a part has an instance");
        for (const Mat4d& instance : part.instances)
            for (int k = 0; k < 4; ++k)
                require(is_finite(Vec3d(instance[k])), "instances are finite");
    }
    require(next == mesh.triangles.size(), "parts cover all triangles");
}

/// The number of texels that have an owner.
std::size_t check_spans(const SolidAtlas& solid) {
    std::size_t owned = 0;
    for (std::size_t y = 0; y < solid.size; ++y) {
        std::uint32_t next = 0;
        for (const Span& span : solid.row(y)) {
            require(span.x >= next && span.x + span.count <= solid.size, "no texel has two owners");
            require(span.map < solid.maps.size(), "spans have maps");
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
                require(is_finite(solid.maps[span.map](x, std::int64_t(y))),
                        "solid points are finite");
            next = span.x + span.count;
            owned += span.count;
        }
    }
    return owned;
}

/// Whether every texel of such an atlas has an owner.
bool fills_all(const MeshAtlas& made) {
    return made.patches() || made.atlas().options.kind == AtlasKind::chart;
}

void check_figures(const Mesh& surface, const Atlas& atlas, const SolidAtlas& solid,
                   const Connectivity& connectivity) {
    const AtlasMeasures all =
        measure_atlas(surface, atlas, solid, mesh_edges(surface, connectivity));
    require(std::isfinite(all.use.coverage) && std::isfinite(all.charts.seam_share) &&
                std::isfinite(all.charts.vertex_ratio) && std::isfinite(all.shape.mirrored),
            "measures are finite");
    if (atlas.options.kind == AtlasKind::uv) return;  // places are the file's
    require(all.texels.overlapped == 0, "no charts overlap");
    require(all.texels.outside == 0, "no triangle is outside");
    require(all.shape.flipped == 0, "no triangle is turned over");
}

}  // namespace

void check_mesh(const Mesh& mesh) {
    require(!mesh.triangles.empty(), "a mesh has triangles");
    for (const Vec3d& point : mesh.positions) require(is_finite(point), "points are finite");
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t point : triangle)
            require(point < mesh.positions.size(), "triangles have points");
    require(mesh.source_faces.size() == mesh.triangles.size(), "triangles have faces");
    const CornerAttributes& corners = mesh.corners;
    for (const std::size_t count :
         {corners.normals.size(), corners.colors.size(), corners.uvs.size(), corners.joints.size(),
          corners.weights.size()})
        require(fits(count, mesh), "corners have attributes or none");
    for (const Vec3f& normal : corners.normals)
        require(std::abs(glm::length(normal) - 1.0f) < 1e-3f, "normals are unit vectors");
    check_parts(mesh);
}

void check_atlas(const Mesh& mesh, const Connectivity& connectivity, const MeshAtlas& made) {
    const Atlas& atlas = made.atlas();
    const Mesh& surface = made.mesh(mesh);
    require(atlas.corners.size() == surface.triangles.size(), "triangles have places");
    require(atlas.charts.size() == surface.triangles.size(), "triangles have charts");
    for (const std::uint32_t chart : atlas.charts)
        require(chart < atlas.chart_count, "charts have numbers below their count");
    for (const auto& corners : atlas.corners)
        for (const Vec2d& corner : corners) require(is_finite(corner), "places are finite");
    const SolidAtlas solid =
        rasterize(mesh, made, map_positions(surface, solid_from_mesh(mesh, SolidSpace::unit)));
    require(solid.size == atlas.options.size, "the texture has the size asked for");
    const std::size_t owned = check_spans(solid);
    require(!fills_all(made) || owned == std::size_t{solid.size} * solid.size,
            "every texel has an owner");
    check_figures(surface, atlas, solid,
                  made.patches() ? build_connectivity(surface) : connectivity);
}

}  // namespace burl::fuzz
