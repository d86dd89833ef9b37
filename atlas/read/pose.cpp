#include "atlas/read/pose.h"

#include <filesystem>

#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"
#include "atlas/gltf/document.h"
#include "atlas/gltf/pose.h"
#include "atlas/mesh/mesh_builder.h"
#include "atlas/read/readers.h"

#include <tiny_gltf.h>

namespace burl {
namespace {

Error other_faces(const FileBuffer& mesh, const FileBuffer& posed, const std::string& what) {
    return invalid_file(posed.path, 0,
                        fmt::format("{} {}; a pose must have the faces of its mesh in the same "
                                    "order, so move points only",
                                    what, mesh.path));
}

void check_faces(const PolygonSoup& rest, const PolygonSoup& pose, const FileBuffer& mesh,
                 const FileBuffer& posed) {
    if (pose.face_count() != rest.face_count())
        throw other_faces(
            mesh, posed,
            fmt::format("there are {} faces, but {} in", pose.face_count(), rest.face_count()));
    for (std::size_t face = 0; face < rest.face_count(); ++face) {
        const std::uint32_t corners = rest.face_sizes.empty() ? 3 : rest.face_sizes[face];
        const std::uint32_t posed_corners = pose.face_sizes.empty() ? 3 : pose.face_sizes[face];
        if (corners != posed_corners)
            throw other_faces(
                mesh, posed,
                fmt::format("face {} has {} corners, but {} in", face + 1, posed_corners, corners));
    }
}

/// Throws Error(invalid_file) unless all corners at one point of the mesh's file are in one place
/// of the pose: where they are not, faces or corners come in another order.
void check_points(const PolygonSoup& rest, const PolygonSoup& pose, const FileBuffer& mesh,
                  const FileBuffer& posed) {
    std::vector<std::uint32_t> posed_as(rest.points.size(), no_index);
    std::size_t face = 0, end = 0;
    for (std::size_t c = 0; c < rest.corners.size(); ++c) {
        if (c == end) end += rest.face_sizes.empty() ? 3 : rest.face_sizes[face], ++face;
        std::uint32_t& known = posed_as[rest.corners[c]];
        if (known == no_index) known = pose.corners[c];
        if (pose.points[known] != pose.points[pose.corners[c]])
            throw other_faces(mesh, posed, fmt::format("face {} joins other points than in", face));
    }
}

/// Normals of the triangles' corners, zero for a corner without one; empty where the soup has none.
std::vector<Vec3f> corner_normals_of(const PolygonSoup& soup,
                                     const std::vector<std::uint32_t>& source_corners) {
    const SoupAttribute<Vec3f>& normals = soup.normals;
    if (normals.values.empty()) return {};
    const std::size_t count = source_corners.empty() ? soup.corners.size() : source_corners.size();
    std::vector<Vec3f> result(count, Vec3f(0.0f));
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t corner = source_corners.empty() ? i : source_corners[i];
        const std::uint32_t index =
            normals.of_corner.empty() ? soup.corners[corner] : normals.of_corner[corner];
        if (index != no_index) result[i] = normals.values[index];
    }
    return result;
}

/// The posed places of the corners of the mesh's triangles. The soups have the same faces; polygons
/// are cut as they are at rest.
MeshPose corners_of(PolygonSoup& mesh, const PolygonSoup& posed) {
    const std::vector<std::uint32_t> source_corners = corners_of_triangles(mesh);
    const std::size_t count = source_corners.empty() ? mesh.corners.size() : source_corners.size();
    MeshPose pose;
    pose.positions.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        pose.positions.push_back(
            posed.points[posed.corners[source_corners.empty() ? i : source_corners[i]]] + 0.0);
    // Without normals at rest creases decide, and a pose's own normals may be split elsewhere.
    if (!mesh.normals.values.empty()) pose.normals = corner_normals_of(posed, source_corners);
    return pose;
}

}  // namespace

std::vector<std::string> pose_names(const FileBuffer& mesh) {
    return has_gltf_extension(mesh.path) ? pose_names(load_gltf(mesh)) : std::vector<std::string>();
}

MeshPose read_pose(const FileBuffer& mesh, const FileBuffer& posed, const ReadOptions& options) {
    PolygonSoup soup = parse_mesh(mesh, options);
    const PolygonSoup posed_soup = parse_mesh(posed, options);
    check_faces(soup, posed_soup, mesh, posed);
    check_points(soup, posed_soup, mesh, posed);
    MeshPose pose = corners_of(soup, posed_soup);
    pose.name = std::filesystem::path(posed.path).stem().string();
    return pose;
}

MeshPose read_own_pose(const FileBuffer& mesh, const std::string& name,
                       const ReadOptions& options) {
    if (!has_gltf_extension(mesh.path))
        throw Error(ExitCode::usage,
                    fmt::format("{}: there is no pose \"{}\": only .gltf and .glb have any; "
                                "name a file with the same faces",
                                mesh.path, name));
    const PolygonSoup posed = parse_gltf_pose(mesh, name, options);  // first: it may throw
    PolygonSoup soup = parse_mesh(mesh, options);
    MeshPose pose = corners_of(soup, posed);
    pose.name = name;
    return pose;
}

void check_pose(const MeshPose& pose, const Mesh& mesh) {
    if (pose.positions.size() != 3 * mesh.triangles.size())
        throw Error(ExitCode::runtime,
                    fmt::format("the pose {} has {} triangles, its mesh {}: a file has changed "
                                "since it was read; read both again",
                                pose.name, pose.positions.size() / 3, mesh.triangles.size()));
}

PosedPoints posed_points(const Mesh& mesh, const MeshPose& pose) {
    check_pose(pose, mesh);
    PosedPoints points;
    const std::size_t count = mesh.positions.size();
    points.triangles = mesh.triangles;
    points.positions.resize(count);
    points.rest.resize(count);
    for (std::uint32_t p = 0; p < count; ++p) points.rest[p] = p;
    std::vector<std::uint32_t> next(count, no_index);  // next point split off the same mesh point
    std::vector<bool> placed(count, false);
    for (std::size_t c = 0; c < 3 * mesh.triangles.size(); ++c) {
        const Vec3d& place = pose.positions[c];
        std::uint32_t p = mesh.triangles[c / 3][c % 3];
        if (!placed[p]) points.positions[p] = place, placed[p] = true;
        while (points.positions[p] != place && next[p] != no_index) p = next[p];
        if (points.positions[p] != place) {
            next[p] = std::uint32_t(points.positions.size());
            points.rest.push_back(points.rest[p]);
            points.positions.push_back(place);
            next.push_back(no_index);
            p = next[p];
        }
        points.triangles[c / 3][c % 3] = p;
    }
    return points;
}

Mesh posed_mesh(const Mesh& mesh, const MeshPose& pose, double weight) {
    PosedPoints points = posed_points(mesh, pose);
    Mesh posed = mesh;
    posed.triangles = std::move(points.triangles);
    posed.corners.normals.clear();
    posed.positions.resize(points.rest.size());
    for (std::size_t p = 0; p < points.rest.size(); ++p)
        posed.positions[p] =
            (1.0 - weight) * mesh.positions[points.rest[p]] + weight * points.positions[p];
    return posed;
}

}  // namespace burl
