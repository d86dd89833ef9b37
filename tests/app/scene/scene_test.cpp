// What a file says and what the scene to draw then holds: placements, materials, samplers, and one
// sentence for everything that cannot be drawn.
#include "app/scene/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include "app/export/export.h"
#include "app/image/image_io.h"
#include "atlas/base/error.h"
#include "tests/app/support/export_scene.h"
#include "tests/app/support/sample_scene.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

void write_text(const std::string& path, const std::string& text) {
    std::ofstream(path) << text;
}

/// Three points (0,0,0), (1,0,0), (0,1,0), then their UVs (0,0), (1,0), (0,1), as one buffer.
void write_buffer(const std::string& path) {
    const std::array<float, 15> values{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1};
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(values.data()), sizeof values);
}

/// A glTF with one triangle; `rest` adds the members that differ between tests.
std::string triangle_gltf(const std::string& nodes, const std::string& material_members,
                          const std::string& rest, const std::string& uv_name = "TEXCOORD_0") {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + nodes +
           R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0,")" + uv_name +
           R"(":1},"material":0}]}],"materials":[{"pbrMetallicRoughness":{)" + material_members +
           R"(}}],"accessors":[
             {"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
             {"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"}],
             "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24}],
             "buffers":[{"uri":"data.bin","byteLength":60}])" +
           rest + "}";
}

const std::string textured = R"("baseColorTexture":{"index":0})";
const std::string png_texture =
    R"(,"textures":[{"source":0,"sampler":0}],"images":[{"uri":"t.png"}],"samplers":[{}])";

struct SceneFolder : ScratchFolder {
    SceneFolder() {
        write_buffer(*this / "data.bin");
        write_png(*this / "t.png", Image<Rgb8>(2, 3, {10, 20, 30}));
    }
    Scene load(const std::string& gltf) const {
        write_text(*this / "s.gltf", gltf);
        return load_scene(*this / "s.gltf");
    }
    std::pair<ExitCode, std::string> failure(const std::string& gltf) const {
        try {
            load(gltf);
        } catch (const Error& error) {
            return {error.code(), error.what()};
        }
        return {ExitCode::ok, ""};
    }
};

TEST(GltfScene, PlacementsComposeDownTheTree) {
    const SceneFolder folder;
    const Scene scene = folder.load(triangle_gltf(
        R"([{"children":[1,2],"translation":[10,0,0]},
            {"mesh":0,"scale":[2,3,4]},{"mesh":0,"translation":[0,5,0]}])",
        "", ""));
    ASSERT_EQ(scene.surfaces.size(), 1u);
    const Surface& surface = scene.surfaces[0];
    ASSERT_EQ(surface.placements.size(), 2u);
    EXPECT_EQ(surface.placements[0] * Vec4d(1, 1, 1, 1), Vec4d(12, 3, 4, 1));
    EXPECT_EQ(surface.placements[1] * Vec4d(1, 1, 1, 1), Vec4d(11, 6, 1, 1));
    // Box (10,0,0)..(12,6,0) of both placements.
    const Sphere sphere = bounding_sphere(scene);
    EXPECT_EQ(sphere.centre, Vec3d(11, 3, 0));
    EXPECT_NEAR(sphere.radius, std::sqrt(10.0), 1e-12);
}

TEST(GltfScene, WeightsAreThoseOfTheFirstNodeDrawnThatHasSome) {
    const SceneFolder folder;
    std::string gltf = triangle_gltf(
        R"([{"children":[2,3]},{"mesh":0,"weights":[0.75]},{"mesh":0},{"mesh":0,"weights":[0.25]}])",
        "", "");
    gltf.insert(gltf.find(R"("material":0)"), R"("targets":[{"POSITION":0}],)");
    EXPECT_EQ(folder.load(gltf).surfaces.at(0).target_share, 0.25);
}

TEST(GltfScene, MissingNormalsAreFlat) {
    const SceneFolder folder;
    const Scene scene = folder.load(triangle_gltf(R"([{"mesh":0}])", "", ""));
    EXPECT_THAT(scene.surfaces[0].normals,
                ElementsAre(Vec3f(0, 0, 1), Vec3f(0, 0, 1), Vec3f(0, 0, 1)));
    EXPECT_EQ(scene.surfaces[0].uvs.size(), 3u);
}

TEST(GltfScene, FactorAndTexture) {
    const SceneFolder folder;
    const Scene scene = folder.load(triangle_gltf(
        R"([{"mesh":0}])", textured + R"(,"baseColorFactor":[0.5,0.25,0.125,1])", png_texture));
    const Surface& surface = scene.surfaces[0];
    EXPECT_EQ(surface.material.factor, Vec4f(0.5f, 0.25f, 0.125f, 1.0f));
    ASSERT_EQ(surface.material.texture, 0);
    EXPECT_EQ(scene.textures.at(0).image, Image<Rgb8>(2, 3, {10, 20, 30}));
    EXPECT_THAT(surface.uvs, ElementsAre(Vec2d(0, 0), Vec2d(1, 0), Vec2d(0, 1)));
}

TEST(GltfScene, SamplersChooseFilterAndWrap) {
    const SceneFolder folder;
    const auto load = [&](const std::string& sampler) {
        return folder
            .load(triangle_gltf(R"([{"mesh":0}])", textured,
                                R"(,"textures":[{"source":0,"sampler":0}],
                                    "images":[{"uri":"t.png"}],"samplers":[)" +
                                    sampler + "]"))
            .textures.at(0);
    };
    const SceneTexture plain = load("{}");
    EXPECT_EQ(plain.filter, TextureFilter::linear);
    EXPECT_EQ(plain.wrap_u, TextureWrap::repeat);
    EXPECT_EQ(load(R"({"minFilter":9728})").filter, TextureFilter::nearest);
    EXPECT_EQ(load(R"({"magFilter":9728})").filter, TextureFilter::nearest);
    EXPECT_EQ(load(R"({"minFilter":9729})").filter, TextureFilter::linear);
    EXPECT_EQ(load(R"({"minFilter":9987})").filter, TextureFilter::mip);
    const SceneTexture wrapped = load(R"({"wrapS":33071,"wrapT":33648})");
    EXPECT_EQ(wrapped.wrap_u, TextureWrap::clamp);
    EXPECT_EQ(wrapped.wrap_v, TextureWrap::mirror);
}

TEST(GltfScene, SecondSetOfTextureCoordinates) {
    const SceneFolder folder;
    const Scene scene = folder.load(triangle_gltf(R"([{"mesh":0}])",
                                                  R"("baseColorTexture":{"index":0,"texCoord":1})",
                                                  png_texture, "TEXCOORD_1"));
    EXPECT_THAT(scene.surfaces[0].uvs, ElementsAre(Vec2d(0, 0), Vec2d(1, 0), Vec2d(0, 1)));
}

TEST(GltfScene, WhatCannotBeDrawnIsSaid) {
    const SceneFolder folder;
    write_text(folder / "t.jpg", "\xff\xd8\xff\xe0 not a png");
    write_text(folder / "bad.png", "\x89PNG\r\n\x1a\n and then nothing");
    const auto with = [&](const std::string& images) {
        return folder.failure(
            triangle_gltf(R"([{"mesh":0}])", textured,
                          R"(,"textures":[{"source":0}],"images":[)" + images + "]"));
    };
    const auto [missing, missing_text] = with(R"({"uri":"nowhere.png"})");
    EXPECT_EQ(missing, ExitCode::io);
    EXPECT_THAT(missing_text, HasSubstr("nowhere.png"));
    const auto [jpeg, jpeg_text] = with(R"({"uri":"t.jpg","mimeType":"image/jpeg"})");
    EXPECT_EQ(jpeg, ExitCode::invalid_file);
    EXPECT_THAT(jpeg_text, HasSubstr("damaged JPEG"));
    write_text(folder / "t.ktx2", "\xabKTX 20\xbb\r\n\x1a\n and then nothing");
    EXPECT_EQ(with(R"({"uri":"t.ktx2"})").first, ExitCode::unsupported);
    EXPECT_EQ(with(R"({"uri":"bad.png"})").first, ExitCode::invalid_file);
    EXPECT_EQ(folder
                  .failure(triangle_gltf(R"([{"mesh":0}])", textured,
                                         R"(,"textures":[{"extensions":{"EXT_texture_webp":{}}}])"))
                  .first,
              ExitCode::unsupported);
    const auto [transform, transform_text] = folder.failure(triangle_gltf(
        R"([{"mesh":0}])",
        R"("baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{"scale":[2,2]}}})",
        png_texture));
    EXPECT_EQ(transform, ExitCode::unsupported);
    EXPECT_THAT(transform_text, HasSubstr("KHR_texture_transform"));
    const auto [uvless, uvless_text] =
        folder.failure(triangle_gltf(R"([{"mesh":0}])", textured, png_texture, "TEXCOORD_3"));
    EXPECT_EQ(uvless, ExitCode::invalid_file);
    EXPECT_THAT(uvless_text, HasSubstr("TEXCOORD_0"));
    EXPECT_EQ(folder.failure(triangle_gltf(R"([{}])", "", "")).first, ExitCode::invalid_file);
}

TEST(GltfScene, PlacedOutOfRangeIsAnError) {
    const SceneFolder folder;
    EXPECT_EQ(
        folder
            .failure(triangle_gltf(
                R"([{"mesh":0,"scale":[1e300,1e300,1e300],"translation":[1e300,0,0]}])", "", ""))
            .first,
        ExitCode::invalid_file);
}

TEST(ObjScene, KeepsColorMapAndOrientation) {
    const ScratchFolder folder;
    Image<Rgb8> image(2, 2, {1, 2, 3});
    write_png(folder / "m.png", image);
    write_text(folder / "m.mtl",
               "newmtl other\nKd 1 0 0\nnewmtl mine\nKd 0.5 1 0.25\nmap_Kd m.png\n");
    write_text(folder / "m.obj",
               "mtllib m.mtl\nusemtl mine\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 0.75\n"
               "f 1/1 2/2 3/3\n");
    const Scene scene = load_scene(folder / "m.obj");
    EXPECT_TRUE(scene.notes.empty());
    EXPECT_EQ(scene.textures.at(0).image, image);
    EXPECT_EQ(scene.surfaces.at(0).material.factor, Vec4f(0.5f, 1.0f, 0.25f, 1.0f));
    EXPECT_THAT(scene.surfaces[0].uvs, ElementsAre(Vec2d(0, 1), Vec2d(1, 1), Vec2d(0, 0.25)));
}

TEST(ObjScene, SaysWhatItLeavesOut) {
    const ScratchFolder folder;
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";
    const auto notes_of = [&](const std::string& text) {
        write_text(folder / "m.obj", triangle + text);
        const Scene scene = load_scene(folder / "m.obj");
        EXPECT_EQ(scene.surfaces.at(0).material.factor, default_grey);
        return scene.notes;
    };
    EXPECT_TRUE(notes_of("f 1/1 2/1 3/1\n").empty());
    EXPECT_THAT(notes_of("mtllib no.mtl\nusemtl a\nf 1/1 2/1 3/1\n"),
                ElementsAre(HasSubstr("no.mtl")));
    EXPECT_THAT(notes_of("mtllib no.mtl\nusemtl a\nf 1/1 2/1 3/1\nusemtl b\nf 1/1 2/1 3/1\n"),
                ElementsAre(HasSubstr("no.mtl")));
    write_text(folder / "m.mtl", "newmtl b\nKd 1 1 1\n");
    EXPECT_THAT(notes_of("mtllib m.mtl\nusemtl a\nf 1/1 2/1 3/1\n"),
                ElementsAre(HasSubstr("no material a")));
}

TEST(ObjScene, BadMaterialsAreErrors) {
    const ScratchFolder folder;
    write_text(folder / "m.obj",
               "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n");
    const auto code_of = [&](const std::string& material) {
        write_text(folder / "m.mtl", "newmtl a\n" + material);
        try {
            load_scene(folder / "m.obj");
        } catch (const Error& error) {
            return error.code();
        }
        return ExitCode::ok;
    };
    EXPECT_EQ(code_of("Kd 1 1 1"), ExitCode::ok);
    EXPECT_EQ(code_of("Kd 1 1"), ExitCode::invalid_file);
    EXPECT_EQ(code_of("Kd red"), ExitCode::invalid_file);
    EXPECT_EQ(code_of("map_Kd missing.png"), ExitCode::io);
    write_text(folder / "photo.jpg", "no photo");
    EXPECT_EQ(code_of("map_Kd photo.jpg"), ExitCode::invalid_file);
    EXPECT_EQ(code_of("map_Kd -s 2 2 2 m.png"), ExitCode::unsupported);
}

TEST(Scene, UnknownFormatsAreUnsupported) {
    const ScratchFolder folder;
    write_text(folder / "a.xyz", "hello");
    try {
        load_scene(folder / "a.xyz");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::unsupported);
    }
}

TEST(Scene, PlainMeshesWithoutColoursAreSaidToBeGrey) {
    const ScratchFolder folder;
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\n";
    const std::string faces =
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    write_text(folder / "grey.ply", head + faces + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    EXPECT_THAT(load_scene(folder / "grey.ply").notes,
                ElementsAre(HasSubstr("grey.ply: drawn grey: ")));
    const std::string colors = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    write_text(folder / "red.ply",
               head + colors + faces + "0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n3 0 1 2\n");
    EXPECT_TRUE(load_scene(folder / "red.ply").notes.empty());
}

/// The exporter's files, read back, are the mesh and texture again.
TEST(Scene, EveryExportedFormatComesBack) {
    const ScratchFolder folder;
    Mesh mesh = cube_mesh({100, -50, 25});
    mesh.parts[0].instances.push_back(placement(30, {1, 1, 1}, {5, 0, 0}));
    const Atlas atlas = pair_atlas(mesh, 32);
    const Image<Rgb8> image = sample_image(32);
    const Sphere sphere = bounding_sphere(mesh);
    for (const char* name : {"a.glb", "b.gltf", "c.obj"}) {
        export_scene(folder / name, mesh, atlas, image);
        const Scene scene = load_scene(folder / name);
        EXPECT_EQ(scene.textures.at(0).image, image) << name;
        const Sphere loaded = bounding_sphere(scene);
        EXPECT_NEAR(glm::distance(loaded.centre, sphere.centre), 0.0, 1e-4) << name;
        EXPECT_NEAR(loaded.radius, sphere.radius, 1e-4) << name;
        std::size_t drawn = 0;
        for (const Surface& surface : scene.surfaces) {
            drawn += surface.triangles.size() * surface.placements.size();
        }
        EXPECT_EQ(drawn, 24u) << name;
        const Surface& surface = scene.surfaces.front();
        const std::uint32_t first = surface.triangles[0][0];
        const Vec2d uv = atlas.corners[0][0] / 32.0;
        EXPECT_NEAR(glm::distance(surface.uvs[first], uv), 0.0, 1e-6) << name;
    }
}

}  // namespace
}  // namespace burl
