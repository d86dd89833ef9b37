// Builds a Mesh from a reader's polygons in a few linear passes; nothing here is format-specific.
#include "atlas/mesh/mesh_builder.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numeric>

#include "atlas/base/error.h"
#include "atlas/base/stop.h"
#include "atlas/mesh/copies.h"
#include "atlas/mesh/mesh.h"
#include "atlas/mesh/polygon.h"
#include "atlas/mesh/weld.h"

namespace burl {

namespace {

/// The soup cut into triangles; `source_corners` is empty where all its faces are triangles.
struct Triangulation {
    std::vector<std::uint32_t> point_of_corner;
    /// The soup's corner of each triangle corner.
    std::vector<std::uint32_t> source_corners;
    std::vector<std::uint32_t> faces;  ///< soup's face of each triangle
};

void check_size(const PolygonSoup& soup, const std::string& path, std::uint64_t most) {
    const std::size_t faces = soup.face_count();
    if (faces == 0) throw invalid_file(path, 0, "the file holds no face, so there is no surface");
    if (soup.corners.size() - 2 * faces > largest_triangle_count)
        throw Error(ExitCode::unsupported, fmt::format("{}: more than {} triangles; split the mesh",
                                                       path, largest_triangle_count));
    if (soup.corners.size() - 2 * faces > most)
        throw Error(ExitCode::unsupported,
                    fmt::format("{}: {} triangles are more than {} (--max-triangles); split the "
                                "mesh, or allow more",
                                path, soup.corners.size() - 2 * faces, most));
}

Triangulation take_triangles(PolygonSoup& soup) {
    Triangulation cut;
    cut.point_of_corner = std::move(soup.corners);
    cut.faces.resize(cut.point_of_corner.size() / 3);
    std::iota(cut.faces.begin(), cut.faces.end(), 0u);
    return cut;
}

Triangulation triangulate(PolygonSoup& soup, MeshNotes& notes) {
    if (soup.face_sizes.empty()) return take_triangles(soup);
    Triangulation cut;
    const std::size_t triangles = soup.corners.size() - 2 * soup.face_sizes.size();
    cut.source_corners.reserve(3 * triangles);
    cut.faces.reserve(triangles);
    PolygonTriangulator triangulator;
    std::vector<Vec3d> outline;
    std::uint32_t first = 0;
    for (std::uint32_t face = 0; face < soup.face_sizes.size(); ++face) {
        const std::uint32_t size = soup.face_sizes[face];
        outline.resize(size);
        for (std::uint32_t i = 0; i < size; ++i) outline[i] = soup.points[soup.corners[first + i]];
        for (const auto& triangle : triangulator(outline)) {
            for (const std::uint32_t corner : triangle)
                cut.source_corners.push_back(first + corner);
            cut.faces.push_back(face);
        }
        notes.polygons += size > 3;
        first += size;
    }
    cut.point_of_corner.resize(cut.source_corners.size());
    for (std::size_t i = 0; i < cut.source_corners.size(); ++i)
        cut.point_of_corner[i] = soup.corners[cut.source_corners[i]];
    if (triangulator.forced() > 0)
        notes.sentences.push_back(fmt::format(
            "{} polygons cross themselves or are too intricate; their triangles may overlap",
            triangulator.forced()));
    return cut;
}

/// The attribute's value at each triangle corner, `missing` where the soup gives that corner none.
/// Empty where the soup has no such attribute.
template <typename Value>
std::vector<Value> to_corners(const SoupAttribute<Value>& attribute, const Triangulation& cut,
                              const Value& missing) {
    if (attribute.values.empty()) return {};
    const bool per_point = attribute.of_corner.empty();
    std::vector<Value> values(cut.point_of_corner.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t corner = cut.source_corners.empty() ? i : cut.source_corners[i];
        const std::uint32_t index =
            per_point ? cut.point_of_corner[i] : attribute.of_corner[corner];
        values[i] = index == no_index ? missing : attribute.values[index];
    }
    return values;
}

CornerAttributes gather_attributes(const PolygonSoup& soup, const Triangulation& cut) {
    CornerAttributes corners;
    corners.normals = to_corners(soup.normals, cut, Vec3f(0.0f));
    corners.colors = to_corners(soup.colors, cut, Vec4f(1.0f));
    corners.uvs = to_corners(soup.uvs, cut, Vec2d(0.0));
    corners.joints = to_corners(soup.joints, cut, {});
    corners.weights = to_corners(soup.weights, cut, Vec4f(1.0f, 0.0f, 0.0f, 0.0f));
    return corners;
}

/// Unit normal of triangle t, computed so that neither huge nor tiny meshes lose it; +z for a
/// triangle without area.
Vec3f face_normal(const Mesh& mesh, std::size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const double scale = longest_edge(mesh, t);
    if (!(scale > 0.0)) return {0.0f, 0.0f, 1.0f};
    const Vec3d normal = glm::cross((mesh.positions[b] - mesh.positions[a]) / scale,
                                    (mesh.positions[c] - mesh.positions[a]) / scale);
    const double length = glm::length(normal);
    return length > 0.0 ? Vec3f(normal / length) : Vec3f(0.0f, 0.0f, 1.0f);
}

void make_normals_unit(Mesh& mesh) {
    std::uint64_t replaced = 0;
    for (std::size_t i = 0; i < mesh.corners.normals.size(); ++i) {
        Vec3f& normal = mesh.corners.normals[i];
        const double length = glm::length(Vec3d(normal));
        const bool usable = length > 0.0 && std::isfinite(length);
        normal = usable ? Vec3f(Vec3d(normal) / length) : face_normal(mesh, i / 3);
        replaced += !usable;
    }
    if (replaced > 0)
        mesh.notes.sentences.push_back(
            fmt::format("{} corners have no normal; their face's own is used", replaced));
}

/// Replaces colours and texture coordinates that are NaN or infinite, as binary files may hold
/// them, by 1 and 0; the geometry is sound, so the file is not refused.
void make_attributes_finite(Mesh& mesh) {
    std::uint64_t replaced = 0;
    const auto check = [&](auto& values, int components, auto fallback) {
        for (auto& value : values)
            for (int k = 0; k < components; ++k) {
                if (std::isfinite(value[k])) continue;
                value[k] = fallback;
                ++replaced;
            }
    };
    check(mesh.corners.colors, 4, 1.0f);
    check(mesh.corners.uvs, 2, 0.0);
    if (replaced > 0)
        mesh.notes.sentences.push_back(fmt::format(
            "{} colour or texture coordinate values are not finite; replaced", replaced));
}

/// Parts as ranges of triangles instead of faces; cut.faces is ascending.
std::vector<Part> to_parts(std::vector<SoupPart>&& soup_parts, const Triangulation& cut,
                           const std::string& name) {
    if (soup_parts.empty()) {
        Part whole;
        whole.name = name;
        whole.triangle_count = static_cast<std::uint32_t>(cut.faces.size());
        return {whole};
    }
    std::vector<Part> parts;
    const auto first_of = [&](std::size_t face) {
        return std::lower_bound(cut.faces.begin(), cut.faces.end(), face) - cut.faces.begin();
    };
    for (SoupPart& part : soup_parts) {
        const auto first = first_of(part.first_face);
        const auto last = first_of(part.first_face + part.face_count);
        parts.push_back({std::move(part.name), static_cast<std::uint32_t>(first),
                         static_cast<std::uint32_t>(last - first), std::move(part.instances)});
    }
    return parts;
}

/// Longest side of the bounding box of the points that `corners` use.
double longest_side_of(const std::vector<Vec3d>& points,
                       const std::vector<std::uint32_t>& corners) {
    Box3 box{points[corners.front()], points[corners.front()]};
    for (const std::uint32_t corner : corners) {
        box.low = glm::min(box.low, points[corner]);
        box.high = glm::max(box.high, points[corner]);
    }
    return box.longest_side();
}

void weld_into(Mesh& mesh, const std::vector<Vec3d>& points, std::vector<std::uint32_t>&& corners,
               double weld) {
    // A distance below the coordinates' own rounding means exact welding.
    const double distance = weld > 0x1p-50 ? weld * longest_side_of(points, corners) : 0.0;
    WeldedPoints welded = weld_points(points, std::move(corners), distance);
    mesh.positions = std::move(welded.positions);
    mesh.triangles.resize(welded.corners.size() / 3);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        mesh.triangles[t] = {welded.corners[3 * t], welded.corners[3 * t + 1],
                             welded.corners[3 * t + 2]};
    mesh.notes.merged_points = welded.merged;
    // Points of faces that were not chosen are not without a face.
    mesh.notes.unreferenced_points = mesh.notes.unchosen_triangles == 0 ? welded.unreferenced : 0;
}

/// Number of triangles with a repeated point or an area of at most zero_area times the squared
/// longest side of the bounding box.
std::uint64_t count_degenerate_triangles(const Mesh& mesh) {
    const double side = bounding_box(mesh).longest_side();
    if (!(side > 0.0)) return mesh.triangles.size();
    std::uint64_t count = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3d ab = (mesh.positions[b] - mesh.positions[a]) / side;
        const Vec3d ac = (mesh.positions[c] - mesh.positions[a]) / side;
        const Vec3d normal = glm::cross(ab, ac);
        count += glm::dot(normal, normal) <= 4.0 * zero_area * zero_area;
    }
    return count;
}

/// Number of triangles on the same three points, in whatever order, as an earlier one.
std::uint64_t count_duplicate_triangles(const Mesh& mesh) {
    std::uint64_t count = 0;
    visit_copies(mesh.triangles, in_order, [&](std::uint32_t, std::uint32_t) { ++count; });
    return count;
}

}  // namespace

std::vector<std::uint32_t> corners_of_triangles(PolygonSoup& soup) {
    if (soup.face_sizes.empty()) return {};
    MeshNotes notes;
    return triangulate(soup, notes).source_corners;
}

Mesh build_mesh(PolygonSoup&& soup, const std::string& path, const ReadOptions& options,
                const std::stop_token& stop) {
    check_size(soup, path, options.most_triangles);
    Mesh mesh;
    mesh.name = std::filesystem::path(path).stem().string();
    mesh.notes = std::move(soup.notes);
    Triangulation cut = triangulate(soup, mesh.notes);
    check_stop(stop);
    mesh.corners = gather_attributes(soup, cut);
    mesh.parts = to_parts(std::move(soup.parts), cut, mesh.name);
    check_stop(stop);
    weld_into(mesh, soup.points, std::move(cut.point_of_corner), options.weld);
    check_stop(stop);
    mesh.source_faces = std::move(cut.faces);
    if (!soup.source_faces.empty())
        for (std::uint32_t& face : mesh.source_faces) face = soup.source_faces[face];
    make_normals_unit(mesh);
    make_attributes_finite(mesh);
    check_stop(stop);
    mesh.notes.degenerate_triangles = count_degenerate_triangles(mesh);
    check_stop(stop);
    mesh.notes.duplicate_triangles = count_duplicate_triangles(mesh);
    return mesh;
}

}  // namespace burl
