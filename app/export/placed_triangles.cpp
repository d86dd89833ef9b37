#include "app/export/placed_triangles.h"

#include <bit>

#include "app/base/unique_rows.h"
#include "app/export/obj_text.h"
#include "app/surface/node_transform.h"
#include "app/surface/normals.h"
#include "app/surface/posed_corners.h"

namespace burl {

namespace {

/// Adds the triangles of a part in a further placement, with the vertices that they use.
void add_placement(PlacedTriangles& out, std::size_t first, std::size_t count,
                   const Mat4d& placement) {
    constexpr std::uint32_t none = 0xffffffffu;
    const NormalTransform normal_transform(placement);
    std::vector<std::uint32_t> number(out.points.size(), none);
    for (std::size_t t = first; t < first + count; ++t) {
        Triangle triangle = out.triangles[t];
        for (std::uint32_t& v : triangle) {
            std::uint32_t& known = number[v];
            if (known == none) {
                known = std::uint32_t(out.points.size());
                out.points.emplace_back(placement * Vec4d(out.points[v], 1.0));
                out.normals.push_back(normal_transform(out.normals[v]));
                if (!out.uvs.empty()) out.uvs.push_back(Vec2d(out.uvs[v]));
                if (!out.colors.empty()) out.colors.push_back(Vec4f(out.colors[v]));
            }
            v = known;
        }
        if (normal_transform.mirrors()) std::swap(triangle[1], triangle[2]);
        out.triangles.push_back(triangle);
    }
}

/// The texture coordinate of a corner, with v = 1 at image row 0.
Vec2d uv_of_corner(const Atlas& atlas, std::size_t corner) {
    const Vec2d size = atlas.extent(), texel = atlas.corners[corner / 3][corner % 3];
    return {texel.x / size.x, (size.y - texel.y) / size.y};
}

}  // namespace

ShownMesh shown_mesh(const SceneContent& content) {
    std::vector<Vec3f> rest = corner_normals(content.mesh, content.options.crease_degrees);
    if (!content.options.pose) return {content.mesh, std::move(rest)};
    const auto& [pose, weight] = *content.options.pose;
    std::vector<Vec3f> normals =
        blended_normals(rest, posed_corners(content.mesh, pose, rest).normals, weight);
    return {posed_mesh(content.mesh, pose, weight), std::move(normals)};
}

PlacedTriangles placed_triangles(const SceneContent& content) {
    const auto [mesh, normals] = shown_mesh(content);
    const Atlas& atlas = content.atlas;
    const std::vector<Vec4f>& colors = content.options.vertex_colors;
    const bool textured = !atlas.corners.empty();
    CornerLines lines;
    if (textured) lines = corner_lines(atlas, normals);
    UniqueRows<3> normal_rows(normals.size() / 2);
    UniqueRows<3> rows(normals.size() / 3);
    PlacedTriangles out;
    for (std::size_t c = 0; c < normals.size(); ++c) {
        const std::uint32_t point = mesh.triangles[c / 3][c % 3], uv = textured ? lines.uv[c] : 0,
                            normal = normal_rows.insert(
                                std::bit_cast<std::array<std::uint32_t, 3>>(normals[c] + 0.0f)),
                            vertex = rows.insert({point, uv, normal});
        if (vertex == out.points.size()) {
            out.points.push_back(mesh.positions[point] + 0.0);
            out.normals.push_back(normals[c] + 0.0f);
            if (textured) out.uvs.push_back(uv_of_corner(atlas, c) + 0.0);
            if (!colors.empty()) out.colors.push_back(colors[content.mesh.triangles[c / 3][c % 3]]);
        }
        if (c % 3 == 0) out.triangles.emplace_back();
        out.triangles.back()[c % 3] = vertex;
    }
    for (const Part& part : mesh.parts)
        for (std::size_t i = 1; i < part.instances.size(); ++i)
            add_placement(out, part.first_triangle, part.triangle_count, part.instances[i]);
    return out;
}

}  // namespace burl
