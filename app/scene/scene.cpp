#include "app/scene/scene.h"

#include <algorithm>
#include <cmath>

#include "app/surface/normals.h"
#include "app/surface/tangents.h"
#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"
#include "atlas/read/read_mesh.h"

namespace burl {

namespace {

Scene load_plain_mesh(const std::string& path, std::uint64_t most_triangles) {
    const Mesh mesh = read_mesh(path, {.most_triangles = most_triangles});
    const bool colored = !mesh.corners.colors.empty();
    Scene scene = scene_from_mesh(mesh, {colored ? Vec4f(1.0f) : default_grey, -1});
    if (!colored)
        scene.notes.push_back(fmt::format(
            "{}: drawn grey: of this format colours of points are drawn, and no picture; "
            "render a .glb or .obj, or add --lazy with a recipe",
            path));
    return scene;
}

/// Replaces values per vertex, if any, by values per triangle corner.
template <class T>
void spread(std::vector<T>& values, const std::vector<Triangle>& triangles) {
    if (values.empty()) return;
    std::vector<T> spread;
    for (const Triangle& triangle : triangles)
        for (const std::uint32_t vertex : triangle) spread.push_back(values[vertex]);
    values = std::move(spread);
}

/// Adds triangle t of the mesh, with corners of its own.
void add_triangle(Surface& surface, const Mesh& mesh, const std::vector<Vec3f>& normals,
                  std::size_t t) {
    const auto first = std::uint32_t(surface.positions.size());
    surface.triangles.push_back({first, first + 1, first + 2});
    for (std::size_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
        surface.positions.push_back(mesh.positions[mesh.triangles[t][corner - 3 * t]]);
        surface.normals.push_back(normals[corner]);
        if (!mesh.corners.uvs.empty()) surface.uvs.push_back(mesh.corners.uvs[corner]);
        if (!mesh.corners.colors.empty()) surface.colors.push_back(mesh.corners.colors[corner]);
    }
}

}  // namespace

Scene load_scene(const std::string& path, const std::string& pose, NamedFiles named,
                 std::uint64_t most_triangles) {
    const std::string extension = lower_extension(path);
    const bool gltf = extension == ".glb" || extension == ".gltf";
    if (!gltf && !pose.empty())
        throw Error(ExitCode::usage,
                    fmt::format("--pose {}: only a .gltf or .glb that is drawn has poses of its "
                                "own; leave it out",
                                pose));
    Scene scene = gltf ? load_gltf_scene(read_file(path, named), pose, most_triangles)
                  : extension == ".obj" ? load_obj_scene(path, named, most_triangles)
                                        : load_plain_mesh(path, most_triangles);
    if (scene.surfaces.empty()) throw invalid_file(path, 0, "the scene holds no triangle to draw");
    if (!std::isfinite(bounding_sphere(scene).radius)) {
        throw invalid_file(path, 0, "the scene's points lie too far out to draw");
    }
    return scene;
}

Scene scene_from_mesh(const Mesh& mesh, const SceneMaterial& material) {
    return scene_from_mesh(mesh, {&material, 1}, {});
}

Scene scene_from_mesh(const Mesh& mesh, std::span<const SceneMaterial> materials,
                      std::span<const std::uint32_t> of_triangle) {
    const std::vector<Vec3f> normals = corner_normals(mesh, 40.0);
    Scene scene;
    for (const Part& part : mesh.parts) {
        std::vector<Surface> surfaces(materials.size());
        for (std::uint32_t k = 0; k < part.triangle_count; ++k) {
            const std::size_t t = part.first_triangle + k;
            add_triangle(surfaces[of_triangle.empty() ? 0 : of_triangle[t]], mesh, normals, t);
        }
        for (std::size_t m = 0; m < surfaces.size(); ++m) {
            if (surfaces[m].triangles.empty()) continue;
            surfaces[m].material = materials[m];
            surfaces[m].placements = part.instances;
            if (materials[m].normals >= 0) add_tangents(surfaces[m]);
            scene.surfaces.push_back(std::move(surfaces[m]));
        }
    }
    return scene;
}

void add_tangents(Surface& surface) {
    spread(surface.positions, surface.triangles);
    spread(surface.normals, surface.triangles);
    spread(surface.uvs, surface.triangles);
    spread(surface.colors, surface.triangles);
    spread(surface.blocks, surface.triangles);
    spread(surface.target.positions, surface.triangles);
    spread(surface.target.normals, surface.triangles);
    surface.target.tangents.clear();  // these belong to other tangents
    std::uint32_t corner = 0;
    for (Triangle& triangle : surface.triangles)
        for (std::uint32_t& vertex : triangle) vertex = corner++;
    surface.tangents =
        corner_tangents(surface.positions, surface.triangles, surface.uvs, surface.normals);
}

Sphere bounding_sphere(const Scene& scene) {
    return sphere_around([&](auto visit) {
        for (const Surface& surface : scene.surfaces) {
            for (const Mat4d& placement : surface.placements) {
                for (const Triangle& triangle : surface.triangles) {
                    for (const std::uint32_t vertex : triangle) {
                        const Vec3d& point = surface.positions[vertex];
                        visit(Vec3d(placement * Vec4d(point, 1.0)));
                        if (surface.target.positions.empty()) continue;
                        const Vec3d end = point + surface.target.positions[vertex];
                        visit(Vec3d(placement * Vec4d(end, 1.0)));
                    }
                }
            }
        }
    });
}

void turn(Scene& scene, const Mat4d& turn) {
    for (Surface& surface : scene.surfaces)
        for (Mat4d& placement : surface.placements) placement = turn * placement;
}

Mat4d unit_frame(const Surface& surface) {
    const Sphere sphere = sphere_around([&](auto visit) {
        for (const Vec3d& p : surface.positions) visit(p);
    });
    Mat4d frame(sphere.radius > 0.0 ? sphere.radius : 1.0);
    frame[3] = Vec4d(sphere.centre, 1.0);
    return frame;
}

std::vector<Mat4d> unit_frames(const Scene& scene) {
    std::vector<Mat4d> frames;
    for (const Surface& surface : scene.surfaces) frames.push_back(unit_frame(surface));
    return frames;
}

}  // namespace burl
