// Writes .glb and .gltf files that reach into the exporter's corners, for the Khronos validator:
// gltf_samples FOLDER.
#include <cstdio>
#include <fstream>
#include <string>

#include "app/export/export.h"
#include "tests/app/support/export_scene.h"
#include "tests/app/support/kept_samples.h"
#include "tests/app/support/sample_scene.h"

namespace {

using namespace burl;

void write(const std::string& path, const Mesh& mesh, Overscan overscan = Overscan::bilinear) {
    const Atlas atlas = pair_atlas(mesh, 64, overscan);
    export_scene(path, mesh, atlas, sample_image(64), {.recipe_json = R"({"burl": 1})"});
}

Mesh cubes_in_placements() {
    Mesh mesh = cube_mesh(Vec3d(3, 0, 0));
    mesh.parts[0].name = "W\xc3\xbcrfel \"A\"\n";
    const Mat4d shear = placement(0, Vec3d(1, 3, 1), {}) * placement(30, Vec3d(1), {1, 2, 3});
    mesh.parts[0].instances = {Mat4d(1.0),
                               placement(30, Vec3d(1), {0, 0, 5}),
                               placement(200, Vec3d(-2, -2, -2), {0, 9, 0}),
                               placement(90, Vec3d(1, 1, -1), {7, 7, 7}),
                               shear,
                               placement(0, Vec3d(1, 0, 1), {0, 0, 20})};
    return mesh;
}

Mesh degenerate_faces() {
    Mesh mesh = cube_mesh();
    mesh.triangles.push_back({0, 0, 1});
    mesh.triangles.push_back({5, 5, 5});
    mesh.triangles.push_back({0, 1, 2});
    mesh.corners.normals.assign(3 * mesh.triangles.size(), Vec3f(0.0f));
    mesh.corners.normals[4] = Vec3f(0.0f, 0.0f, 2.0f);
    mesh.parts = {{"bad \xff name", 0, 12, {Mat4d(1.0)}}, {"", 12, 3, {Mat4d(1.0)}}};
    return mesh;
}

Mesh scaled_cube(double factor) {
    Mesh mesh = cube_mesh(Vec3d(1e6));
    for (Vec3d& p : mesh.positions) p *= factor;
    return mesh;
}

void write_16_bit(const std::string& path) {
    const Mesh mesh = cube_mesh();
    export_scene(path, mesh, pair_atlas(mesh, 64), Image<Rgb16>(64, 64, {1000, 20000, 65535}));
}

/// Any normals do: what counts is that the document holds them as it must.
void write_normal_map(const std::string& path, const Mesh& mesh) {
    ExportOptions options;
    options.normals = NormalMap{Image<Rgb8>(64, 64, {128, 128, 255}), true};
    options.levels = {Image<Rgb8>(32, 32), Image<Rgb8>(16, 16)};
    export_scene(path, mesh, pair_atlas(mesh, 64), sample_image(64), options);
}

/// A morph target, with tangents, of every placement.
void write_pose(const std::string& path, const Mesh& mesh) {
    ExportOptions options;
    options.normals = NormalMap{Image<Rgb8>(64, 64, {128, 128, 255}), true};
    options.pose = ExportPose{{"stretched \xff", {}, {}}, 0.5};
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t p : t)
            options.pose->corners.positions.push_back(Vec3d(1, 2, 3) * mesh.positions[p]);
    export_scene(path, mesh, pair_atlas(mesh, 64), sample_image(64), options);
}

}  // namespace

int main(int count, char** arguments) try {
    if (count != 2) return 1;
    const std::string folder = std::string(arguments[1]) + "/";
    write(folder + "cube.glb", cube_mesh());
    write(folder + "cube_nearest.glb", cube_mesh(), Overscan::nearest);
    write(folder + "placements.glb", cubes_in_placements());
    write(folder + "two words & \xc3\xbc.gltf", cubes_in_placements());
    write(folder + "degenerate.glb", degenerate_faces());
    write(folder + "tiny.glb", scaled_cube(1e-30));
    write(folder + "huge.glb", scaled_cube(1e30));
    write(folder + "sphere_long_indices.glb", sphere_mesh(180, 200));
    write_16_bit(folder + "sixteen_bit.glb");
    write_normal_map(folder + "normal_map.glb", cubes_in_placements());
    write_normal_map(folder + "normal map.gltf", cubes_in_placements());
    write_normal_map(folder + "normal_map_degenerate.glb", degenerate_faces());
    write_normal_map(folder + "normal_map_tiny.glb", scaled_cube(1e-30));
    write_pose(folder + "pose.glb", cubes_in_placements());
    write_pose(folder + "pose.gltf", degenerate_faces());
    for (const auto& [name, text] : kept_samples())
        std::ofstream(folder + "kept_" + name + ".gltf") << text;
    return 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "gltf_samples: %s\n", e.what());
    return 4;
}
