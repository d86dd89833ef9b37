// Materials that files tell: glTF's numbers, pictures and extensions, MTL's, and Burl's own read
// back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include "app/image/image_io.h"
#include "app/image/picture_coding.h"
#include "app/scene/scene.h"
#include "procedural/color/srgb.h"
#include "tests/app/programs/run_program.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A picture of one colour, whatever its name says.
void write_picture(const std::string& path, const Rgb8& color, const PictureCoding& coding) {
    std::ofstream file(path, std::ios::binary);
    encode_picture(
        Image<Rgb8>(8, 8, color),
        [&](std::span<const std::uint8_t> bytes) {
            file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
        },
        coding);
}

struct MaterialFolder : ScratchFolder {
    MaterialFolder() {
        const std::array<float, 15> values{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1};
        std::ofstream(*this / "data.bin", std::ios::binary)
            .write(reinterpret_cast<const char*>(values.data()), sizeof values);
        for (const char* name : {"a.png", "b.png"})
            write_png(*this / name, Image<Rgb8>(2, 2, {10, 20, 30}));
    }
    /// A triangle with one material, of which `members` are the members.
    Scene load(const std::string& members) const {
        std::ofstream(*this / "s.gltf")
            << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
            "nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,
            "TEXCOORD_0":1},"material":0}]}],"materials":[{)"
            << members << R"(}],"textures":[{"source":0},{"source":1}],
            "images":[{"uri":"a.png"},{"uri":"b.png"}],"accessors":[
            {"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
            {"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"}],
            "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24}],
            "buffers":[{"uri":"data.bin","byteLength":60}]})";
        return load_scene(*this / "s.gltf");
    }
    SceneMaterial material(const std::string& members) const {
        const Scene scene = load(members);
        EXPECT_TRUE(scene.notes.empty()) << scene.notes.front();
        return scene.surfaces.at(0).material;
    }
};

TEST(GltfMaterial, HasTheSpecificationsDefaults) {
    const SceneMaterial m = MaterialFolder().material("");
    EXPECT_EQ(m.metallic, 1.0f);
    EXPECT_EQ(m.roughness, 1.0f);
    EXPECT_EQ(m.emissive, Vec3f(0.0f));
    EXPECT_EQ(m.ior, 1.5f);
    EXPECT_EQ(m.specular, 1.0f);
    EXPECT_EQ(m.clearcoat, 0.0f);
    EXPECT_EQ(m.transmission, 0.0f);
    EXPECT_FALSE(m.unlit);
    EXPECT_EQ(m.maps, no_material_maps);
}

TEST(GltfMaterial, NumbersOfAllExtensions) {
    const SceneMaterial m = MaterialFolder().material(
        R"("pbrMetallicRoughness":{"metallicFactor":0.25,"roughnessFactor":0.75},
        "emissiveFactor":[1,0.5,0],"extensions":{
        "KHR_materials_emissive_strength":{"emissiveStrength":4},
        "KHR_materials_ior":{"ior":1.8},
        "KHR_materials_specular":{"specularFactor":0.5,"specularColorFactor":[1,0.5,2]},
        "KHR_materials_clearcoat":{"clearcoatFactor":0.9,"clearcoatRoughnessFactor":0.1},
        "KHR_materials_sheen":{"sheenColorFactor":[0.1,0.2,0.3],"sheenRoughnessFactor":0.4},
        "KHR_materials_transmission":{"transmissionFactor":0.6}})");
    EXPECT_EQ(m.metallic, 0.25f);
    EXPECT_EQ(m.roughness, 0.75f);
    EXPECT_EQ(m.emissive, Vec3f(4, 2, 0));
    EXPECT_EQ(m.ior, 1.8f);
    EXPECT_EQ(m.specular, 0.5f);
    EXPECT_EQ(m.specular_color, Vec3f(1, 0.5f, 2));
    EXPECT_EQ(m.clearcoat, 0.9f);
    EXPECT_EQ(m.clearcoat_roughness, 0.1f);
    EXPECT_EQ(m.sheen, Vec3f(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(m.sheen_roughness, 0.4f);
    EXPECT_EQ(m.transmission, 0.6f);
    EXPECT_TRUE(MaterialFolder().material(R"("extensions":{"KHR_materials_unlit":{}})").unlit);
}

TEST(GltfMaterial, NumbersOutOfRangeAreBounded) {
    const SceneMaterial m = MaterialFolder().material(
        R"("pbrMetallicRoughness":{"metallicFactor":7,"roughnessFactor":-2},
        "emissiveFactor":[1,1,1],"extensions":{
        "KHR_materials_emissive_strength":{"emissiveStrength":1e300},
        "KHR_materials_ior":{"ior":0.5},"KHR_materials_clearcoat":{"clearcoatFactor":"much"}})");
    EXPECT_EQ(m.metallic, 1.0f);
    EXPECT_EQ(m.roughness, 0.0f);
    EXPECT_EQ(m.emissive, Vec3f(1e6f));
    EXPECT_EQ(m.ior, 1.0f);
    EXPECT_EQ(m.clearcoat, 0.0f);
}

TEST(GltfMaterial, PicturesAreSharedWhereTheFileSharesThem) {
    const Scene scene = MaterialFolder().load(
        R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0},
        "metallicRoughnessTexture":{"index":1}},"occlusionTexture":{"index":1,"strength":0.5},
        "emissiveTexture":{"index":0},"extensions":{"KHR_materials_sheen":{
        "sheenRoughnessTexture":{"index":1}},"KHR_materials_clearcoat":{
        "clearcoatTexture":{"index":0}}})");
    EXPECT_TRUE(scene.notes.empty());
    const SceneMaterial& m = scene.surfaces.at(0).material;
    const int orm = m.map(MaterialMap::metallic_roughness);
    ASSERT_GE(orm, 0);
    EXPECT_EQ(m.map(MaterialMap::occlusion), orm);
    EXPECT_EQ(m.map(MaterialMap::sheen_roughness), orm);
    EXPECT_EQ(m.occlusion_strength, 0.5f);
    EXPECT_EQ(m.map(MaterialMap::emissive), m.texture);
    EXPECT_NE(m.map(MaterialMap::clearcoat), m.texture) << "the same codes, once as data";
    EXPECT_EQ(m.map(MaterialMap::transmission), -1);
    EXPECT_EQ(scene.textures.size(), 3u);
    EXPECT_FALSE(scene.textures[std::size_t(orm)].is_color);
    EXPECT_TRUE(scene.textures[std::size_t(m.texture)].is_color);
}

TEST(GltfMaterial, WhatIsNotDrawnIsSaidOnce) {
    const Scene scene = MaterialFolder().load(
        R"("occlusionTexture":{"index":0,"texCoord":1},"emissiveTexture":{"index":1,
        "extensions":{"KHR_texture_transform":{"scale":[2,2]}}},"extensions":{
        "KHR_materials_volume":{"thicknessFactor":1},"KHR_materials_clearcoat":{
        "clearcoatFactor":1,"clearcoatTexture":{"index":7},"clearcoatNormalTexture":{"index":0}}})");
    EXPECT_THAT(
        scene.notes,
        ElementsAre(HasSubstr("materials[0]: occlusionTexture has other texture coordinates"),
                    HasSubstr("emissiveTexture uses KHR_texture_transform"),
                    HasSubstr("clearcoatTexture is no PNG, JPEG or WebP that is there"),
                    HasSubstr("KHR_materials_volume is not drawn"),
                    HasSubstr("clearcoatNormalTexture is not drawn")));
    EXPECT_EQ(scene.surfaces[0].material.maps, no_material_maps);
    EXPECT_EQ(scene.surfaces[0].material.clearcoat, 1.0f);
}

Scene obj_scene(const MaterialFolder& folder, const std::string& lines) {
    std::ofstream(folder / "m.mtl") << "newmtl a\nKd 1 1 1\n" << lines;
    std::ofstream(folder / "m.obj") << "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                                       "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";
    return load_scene(folder / "m.obj");
}

TEST(ObjMaterial, NumbersAndPicturesOfTheExtension) {
    const MaterialFolder folder;
    write_png(folder / "rough.png", Image<Rgb8>(2, 2, {70, 70, 70}));
    write_png(folder / "metal.png", Image<Rgb8>(2, 2, {90, 90, 90}));
    const Scene scene =
        obj_scene(folder,
                  "Pr 0.25\nPm 0.5\nPc 0.75\nPcr 0.125\nNi 1.7\nKe 2 1 0\n"
                  "map_Pr rough.png\nmap_Pm metal.png\nmap_Ke a.png\nmap_Ps b.png\n");
    EXPECT_TRUE(scene.notes.empty());
    const SceneMaterial& m = scene.surfaces.at(0).material;
    EXPECT_EQ(m.roughness, 1.0f) << "the picture says it";
    EXPECT_EQ(m.clearcoat, 0.75f);
    EXPECT_EQ(m.clearcoat_roughness, 0.125f);
    EXPECT_EQ(m.ior, 1.7f);
    EXPECT_EQ(m.emissive, Vec3f(2, 1, 0));
    EXPECT_EQ(m.sheen, Vec3f(1.0f));
    const int orm = m.map(MaterialMap::metallic_roughness);
    ASSERT_GE(orm, 0);
    EXPECT_EQ(scene.textures[std::size_t(orm)].image(0, 0), (Rgb8{255, 70, 90}));
    EXPECT_FALSE(scene.textures[std::size_t(orm)].is_color);
    EXPECT_TRUE(scene.textures[std::size_t(m.map(MaterialMap::emissive))].is_color);
}

/// The signature counts, not the name.
TEST(GltfMaterial, PicturesMayBeJpegOrWebp) {
    const MaterialFolder folder;
    write_picture(folder / "a.png", {40, 80, 120}, {TextureFormat::jpeg, 100});
    write_picture(folder / "b.png", {200, 30, 10}, {TextureFormat::webp, {}});
    const Scene scene = folder.load(
        R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0}},"emissiveTexture":{"index":1})");
    EXPECT_TRUE(scene.notes.empty());
    const SceneMaterial& m = scene.surfaces.at(0).material;
    const Rgb8 jpeg = scene.textures[std::size_t(m.texture)].image(3, 3);
    EXPECT_NEAR(jpeg.r, 40, 2);
    EXPECT_NEAR(jpeg.g, 80, 2);
    EXPECT_NEAR(jpeg.b, 120, 2);
    const int emissive = m.map(MaterialMap::emissive);
    EXPECT_EQ(scene.textures[std::size_t(emissive)].image(3, 3), (Rgb8{200, 30, 10}));
}

/// Faces of three materials, one of which the library lacks.
TEST(ObjMaterial, EveryFaceHasItsOwn) {
    const MaterialFolder folder;
    std::ofstream(folder / "m.mtl") << "newmtl a\nKd 1 0 0\nPr 0.25\nnewmtl b\nKd 0 1 0\n"
                                       "map_Kd a.png\n";
    std::ofstream(folder / "m.obj")
        << "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
           "usemtl b\nf 1/1 2/2 3/3\nusemtl a\nf 2/1 4/2 3/3\nusemtl b\nf 1/1 2/2 4/3\n"
           "usemtl c\nf 1/1 3/2 4/3\n";
    const Scene scene = load_scene(folder / "m.obj");
    EXPECT_THAT(scene.notes, ElementsAre(HasSubstr("no material c")));
    ASSERT_EQ(scene.surfaces.size(), 3u);
    EXPECT_EQ(scene.surfaces[0].triangles.size(), 2u);
    EXPECT_EQ(scene.surfaces[0].material.factor, Vec4f(0, 1, 0, 1));
    EXPECT_GE(scene.surfaces[0].material.texture, 0);
    EXPECT_EQ(scene.surfaces[1].positions[1], Vec3d(1, 1, 0));
    EXPECT_EQ(scene.surfaces[1].material.factor, Vec4f(1, 0, 0, 1));
    EXPECT_EQ(scene.surfaces[1].material.roughness, 0.25f);
    EXPECT_EQ(scene.surfaces[1].material.texture, -1);
    EXPECT_EQ(scene.surfaces[2].material.factor, default_grey);
}

/// All libraries are read, on as many lines as there are, and the first definition of a name
/// counts.
TEST(ObjMaterial, ComesFromAnyLibrary) {
    const MaterialFolder folder;
    std::filesystem::create_directory(folder / "sub");
    std::ofstream(folder / "m.mtl") << "newmtl a\nKd 1 0 0\n";
    std::ofstream(folder / "n.mtl") << "\xef\xbb\xbfnewmtl b\nKd 0 1 0\nnewmtl a\nKd 0 0 0\n";
    std::ofstream(folder / "sub/two words.mtl") << "newmtl c\nKd 0 0 1\nmap_Kd c.png\n";
    write_png(folder / "sub/c.png", Image<Rgb8>(2, 2, {7, 8, 9}));
    std::ofstream(folder / "m.obj")
        << "\xef\xbb\xbfmtllib m.mtl no.mtl \\\n n.mtl\nmtllib\tsub/two words.mtl\n"
           "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\nusemtl \\\nb\n"
           "f 1/1 2/1 3/1\nusemtl c\nf 1/1 2/1 3/1\nusemtl d\nf 1/1 2/1 3/1\n";
    const Scene scene = load_scene(folder / "m.obj");
    ASSERT_EQ(scene.surfaces.size(), 4u);
    EXPECT_EQ(scene.surfaces[0].material.factor, Vec4f(1, 0, 0, 1));
    EXPECT_EQ(scene.surfaces[1].material.factor, Vec4f(0, 1, 0, 1));
    EXPECT_EQ(scene.surfaces[2].material.factor, Vec4f(0, 0, 1, 1));
    EXPECT_EQ(scene.textures.at(0).image(1, 1), (Rgb8{7, 8, 9}));
    EXPECT_EQ(scene.surfaces[3].material.factor, default_grey);
    EXPECT_THAT(scene.notes, ElementsAre(HasSubstr("material file no.mtl is missing"),
                                         HasSubstr("no material d in m.mtl (and 3 others)")));
    EXPECT_THAT(scene.files, testing::SizeIs(4));
}

/// Joined lines hide a face from those who read line by line, other blanks hide one that is there.
TEST(ObjMaterial, FacesAreCountedAsTheMeshIsRead) {
    const MaterialFolder folder;
    std::ofstream(folder / "m.mtl") << "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 1 0\n";
    std::ofstream(folder / "m.obj")
        << "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nusemtl a\n# as before \\\nf 1 2 3\n"
           "\v\f f 1 2 3\nusemtl b\nf 2 \\\n4 3\n";
    const Scene scene = load_scene(folder / "m.obj");
    ASSERT_EQ(scene.surfaces.size(), 2u);
    EXPECT_EQ(scene.surfaces[0].material.factor, Vec4f(1, 0, 0, 1));
    EXPECT_EQ(scene.surfaces[1].material.factor, Vec4f(0, 1, 0, 1));
    EXPECT_EQ(scene.surfaces[1].positions[1], Vec3d(1, 1, 0));
}

TEST(ObjMaterial, SaysWhatItLeavesOut) {
    const MaterialFolder folder;
    write_png(folder / "small.png", Image<Rgb8>(1, 1));
    EXPECT_THAT(obj_scene(folder, "map_Pr a.png\nmap_Pm small.png\n").notes,
                ElementsAre(HasSubstr("map_Pr and map_Pm differ in size")));
    EXPECT_THAT(obj_scene(folder, "map_Ke photo.jpg\n").notes,
                ElementsAre(HasSubstr("map_Ke photo.jpg is no PNG, JPEG or WebP that is there")));
}

/// A material that `burl bake` writes to OBJ is read back, whoever's order its pictures are in.
TEST(ObjMaterial, BurlsOwnComesBack) {
    const MaterialFolder folder;
    std::ofstream(folder / "r.json")
        << R"({"atlas": {"size": 64}, "solid": {"scale": 3}, "define": {"grain": {"node":
        "smoothstep", "low": -1, "high": 1, "input": {"node": "fbm", "octaves": 2}}},
        "material": {"base_color": "#c9a06a", "roughness": "grain", "metallic": 0.25,
        "emissive": "#ff8020", "emissive_strength": 3, "clearcoat": 0.5, "ior": 1.4}})";
    const auto baked = [&](const std::string& name, const std::string& options) {
        const test::Scratch scratch;
        const test::Outcome outcome =
            test::run_burl(scratch, fmt::format("bake sample:cube -r '{}' -o '{}' {}",
                                                folder / "r.json", folder / name, options));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return load_scene(folder / name);
    };
    const Scene glb = baked("a.glb", "");
    const SceneMaterial& want = glb.surfaces.at(0).material;
    const Image<Rgb8>& orm =
        glb.textures[std::size_t(want.map(MaterialMap::metallic_roughness))].image;
    for (const char* pack : {"separate", "unreal", "unity"}) {
        const Scene scene = baked(fmt::format("{}.obj", pack), fmt::format("--pack {}", pack));
        const SceneMaterial& m = scene.surfaces.at(0).material;
        EXPECT_NEAR(m.emissive.x, want.emissive.x, 1e-5f);
        EXPECT_EQ(m.clearcoat, want.clearcoat);
        EXPECT_EQ(m.ior, want.ior);
        const int number = m.map(MaterialMap::metallic_roughness);
        ASSERT_GE(number, 0) << pack;
        const Image<Rgb8>& have = scene.textures[std::size_t(number)].image;
        ASSERT_EQ(have.width(), orm.width());
        for (std::size_t y = 0; y < orm.height(); ++y)
            for (std::size_t x = 0; x < orm.width(); ++x) {
                EXPECT_NEAR(have(x, y).g, orm(x, y).g, 1) << pack;
                EXPECT_NEAR(m.metallic * float(have(x, y).b), want.metallic * float(orm(x, y).b),
                            1.0f)
                    << pack;
            }
    }
}

}  // namespace
}  // namespace burl
