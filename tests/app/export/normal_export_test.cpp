// Normal maps in files: what names them, what their bytes are, and how they come back.
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/base/file_bytes.h"
#include "app/export/export.h"
#include "app/image/image_io.h"
#include "app/scene/scene.h"
#include "app/surface/normals.h"
#include "app/surface/tangents.h"
#include "atlas/base/json.h"
#include "tests/app/support/export_scene.h"
#include "tests/app/support/sample_scene.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Different in every texel.
ExportOptions with_normals(bool tangent_space = true) {
    ExportOptions options;
    Image<Rgb8> image = sample_image(64);
    image(3, 4) = {1, 2, 3};
    options.normals = NormalMap{image, tangent_space};
    return options;
}

std::string text_of(const std::string& path) {
    const std::vector<std::uint8_t> bytes = read_file_bytes(path);
    return {bytes.begin(), bytes.end()};
}

TEST(NormalExport, NamesTheirFiles) {
    EXPECT_EQ(
        output_paths("x/a.obj", 1, true),
        (std::vector<std::string>{"x/a.obj", "x/a.mtl", "x/a.png", "x/a.1.png", "x/a_normal.png"}));
    EXPECT_EQ(output_paths("a.b.gltf", 0, true).back(), "a.b_normal.png");
    EXPECT_EQ(output_paths("a.png", 0, true).back(), "a_normal.png");
    EXPECT_EQ(output_paths("a.exr", 3, true).back(), "a_normal.png");
    EXPECT_THAT(output_paths("a.glb", 0, true), ElementsAre("a.glb"));
}

TEST(NormalExport, GltfNamesTextureAndTangents) {
    const ScratchFolder folder;
    const Mesh mesh = cube_mesh();
    ExportOptions options = with_normals();
    options.levels = {Image<Rgb8>(32, 32)};
    export_scene(folder / "a b.gltf", mesh, pair_atlas(mesh, 64), sample_image(64), options);
    const auto json = nlohmann::json::parse(text_of(folder / "a b.gltf"));
    EXPECT_EQ(json["materials"][0]["normalTexture"]["index"], 1);
    EXPECT_EQ(json["textures"][1]["source"], 2);
    EXPECT_EQ(json["textures"][1]["sampler"], 0);
    EXPECT_EQ(json["images"][2]["uri"], "a%20b_normal.png");
    const auto& attributes = json["meshes"][0]["primitives"][0]["attributes"];
    const auto& tangent = json["accessors"][attributes["TANGENT"].get<std::size_t>()];
    EXPECT_EQ(tangent["type"], "VEC4");
    EXPECT_EQ(tangent["componentType"], 5126);
    EXPECT_EQ(tangent["count"],
              json["accessors"][attributes["POSITION"].get<std::size_t>()]["count"]);
    EXPECT_EQ(read_png(folder / "a b_normal.png")(3, 4), (Rgb8{1, 2, 3}));
}

TEST(NormalExport, WithoutThereIsNeitherTextureNorTangent) {
    const ScratchFolder folder;
    const Mesh mesh = cube_mesh();
    export_scene(folder / "a.gltf", mesh, pair_atlas(mesh, 64), sample_image(64));
    const std::string text = text_of(folder / "a.gltf");
    EXPECT_THAT(text, Not(HasSubstr("TANGENT")));
    EXPECT_THAT(text, Not(HasSubstr("normalTexture")));
    EXPECT_FALSE(std::filesystem::exists(folder / "a_normal.png"));
}

TEST(NormalExport, PngsOfNormalsAreNotMarkedAsColours) {
    const ScratchFolder folder;
    const Mesh mesh = cube_mesh();
    const Atlas atlas = pair_atlas(mesh, 64);
    for (const char* name : {"a.png", "c.obj"})
        export_scene(folder / name, mesh, atlas, sample_image(64), with_normals());
    export_scene(folder / "b.exr", mesh, atlas, Image<RgbF>(64, 64), with_normals());
    EXPECT_THAT(text_of(folder / "a.png"), HasSubstr("sRGB"));
    for (const char* name : {"a_normal.png", "b_normal.png", "c_normal.png"}) {
        EXPECT_THAT(text_of(folder / name), Not(HasSubstr("sRGB"))) << name;
        EXPECT_EQ(read_png(folder / name)(3, 4), (Rgb8{1, 2, 3})) << name;
    }
}

TEST(NormalExport, ObjMaterialsNameOnlyTangentSpace) {
    const ScratchFolder folder;
    const Mesh mesh = cube_mesh();
    const Atlas atlas = pair_atlas(mesh, 64);
    export_scene(folder / "a.obj", mesh, atlas, sample_image(64), with_normals(true));
    EXPECT_THAT(text_of(folder / "a.mtl"),
                HasSubstr("\nnorm a_normal.png\nmap_Bump -bm 1 a_normal.png\n"));
    export_scene(folder / "b.obj", mesh, atlas, sample_image(64), with_normals(false));
    EXPECT_THAT(text_of(folder / "b.mtl"), Not(HasSubstr("norm")));
    EXPECT_TRUE(std::filesystem::exists(folder / "b_normal.png"));
}

/// Positions, normals and tangents of a surface's corners, in the scene.
struct SceneCorner {
    Vec3d position{0.0}, bitangent{0.0};
};

std::vector<SceneCorner> corners_of(const Scene& scene) {
    std::vector<SceneCorner> corners;
    for (const Surface& surface : scene.surfaces)
        for (const Mat4d& place : surface.placements)
            for (const Triangle& triangle : surface.triangles)
                for (const std::uint32_t v : triangle) {
                    const Vec4f& t = surface.tangents.at(v);
                    const Vec3d b = glm::cross(Vec3d(surface.normals[v]), Vec3d(t)) * double(t.w);
                    corners.push_back({Vec3d(place * Vec4d(surface.positions[v], 1.0)),
                                       glm::normalize(Mat3d(place) * b)});
                }
    return corners;
}

TEST(NormalExport, EveryFormatComesBackWithTheSameFrames) {
    // Placed, mirrored and (in a copy of its own) sheared: the bitangent moves with the surface.
    const ScratchFolder folder;
    Mesh mesh = cube_mesh({3, 0, 0});
    const Mat4d shear = placement(0, Vec3d(1, 3, 1), {}) * placement(30, Vec3d(1), {1, 2, 3});
    mesh.parts[0].instances = {Mat4d(1.0), placement(90, Vec3d(1, 1, -1), {7, 7, 7}), shear};
    const Atlas atlas = pair_atlas(mesh, 64);
    for (const char* name : {"a.glb", "b.gltf"}) {
        export_scene(folder / name, mesh, atlas, sample_image(64), with_normals());
        const Scene scene = load_scene(folder / name);
        ASSERT_EQ(scene.textures.size(), 2u) << name;
        EXPECT_FALSE(scene.textures[std::size_t(scene.surfaces[0].material.normals)].is_color);
        const auto corners = corners_of(scene);
        ASSERT_EQ(corners.size(), 108u) << name;
        int turned = 0;
        for (std::size_t c = 0; c < corners.size(); ++c) {
            // All placements of pair_atlas's squares: image up is a side of the cube.
            const std::size_t first = 3 * std::size_t(c / 3);
            double best = -1.0;
            for (std::size_t k = 0; k < 3; ++k)
                for (const double sign : {-1.0, 1.0}) {
                    const Vec3d side =
                        corners[first + (k + 1) % 3].position - corners[first + k].position;
                    best =
                        std::max(best, sign * glm::dot(glm::normalize(side), corners[c].bitangent));
                }
            turned += best < 0.99;
        }
        EXPECT_LE(turned, 36) << name << ": only the sheared cube may bend its frames";
    }
}

TEST(NormalScenes, WithoutTangentsTheyAreComputed) {
    const ScratchFolder folder;
    const Mesh mesh = sphere_mesh(8, 16);
    const Atlas atlas = pair_atlas(mesh, 128);
    export_scene(folder / "a.obj", mesh, atlas, sample_image(128), with_normals());
    export_scene(folder / "a.gltf", mesh, atlas, sample_image(128), with_normals());
    auto json = nlohmann::json::parse(text_of(folder / "a.gltf"));
    json["meshes"][0]["primitives"][0]["attributes"].erase("TANGENT");
    std::ofstream(folder / "b.gltf") << json;
    const auto given = corners_of(load_scene(folder / "a.gltf"));
    for (const char* name : {"a.obj", "b.gltf"}) {
        const auto computed = corners_of(load_scene(folder / name));
        ASSERT_EQ(computed.size(), given.size()) << name;
        for (std::size_t c = 0; c < given.size(); ++c)
            EXPECT_LT(glm::length(computed[c].bitangent - given[c].bitangent), 1e-3) << name;
    }
}

TEST(NormalScenes, MapsThatCannotBeDrawnAreLeftOutWithANote) {
    const ScratchFolder folder;
    const Mesh mesh = cube_mesh();
    export_scene(folder / "a.gltf", mesh, pair_atlas(mesh, 64), sample_image(64), with_normals());
    const auto json = nlohmann::json::parse(text_of(folder / "a.gltf"));
    const auto note_of = [&](const nlohmann::json& changed) {
        std::ofstream(folder / "b.gltf") << changed;
        const Scene scene = load_scene(folder / "b.gltf");
        EXPECT_EQ(scene.surfaces[0].material.normals, -1);
        EXPECT_EQ(scene.surfaces[0].material.texture, 0);
        return scene.notes.size() == 1 ? scene.notes[0] : "";
    };
    auto changed = json;
    changed["images"][1]["uri"] = "missing.png";
    EXPECT_THAT(note_of(changed), HasSubstr("drawn without"));
    changed = json;
    changed["materials"][0]["normalTexture"]["texCoord"] = 1;
    EXPECT_THAT(note_of(changed), HasSubstr("other texture coordinates"));
    changed = json;
    changed["materials"][0]["normalTexture"]["extensions"]["KHR_texture_transform"]["offset"] = {
        0, 0.5};
    EXPECT_THAT(note_of(changed), HasSubstr("KHR_texture_transform"));
}

}  // namespace
}  // namespace burl
