// What was written, read back by tinygltf and compared with the mesh and atlas it came from.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include "app/export/export.h"
#include "app/image/image_io.h"
#include "app/surface/normals.h"
#include "atlas/base/error.h"
#include "tests/app/support/export_scene.h"
#include "tests/app/support/sample_scene.h"
#include "tests/app/support/scratch_folder.h"
#include "tests/cpu_time.h"

namespace burl {
namespace {

/// Keeps the image's bytes instead of decoding them.
bool keep_bytes(tinygltf::Image* image, const int, std::string*, std::string*, int, int,
                const unsigned char* bytes, int size, void*) {
    image->image.assign(bytes, bytes + size);
    return true;
}

tinygltf::Model load(const std::string& path) {
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(keep_bytes, nullptr);
    tinygltf::Model model;
    std::string errors, warnings;
    const bool text = path.ends_with(".gltf");
    EXPECT_TRUE(text ? loader.LoadASCIIFromFile(&model, &errors, &warnings, path)
                     : loader.LoadBinaryFromFile(&model, &errors, &warnings, path));
    EXPECT_EQ(errors + warnings, "");
    return model;
}

/// Accessor values as doubles, `width` per element.
std::vector<double> values(const tinygltf::Model& model, int accessor_index) {
    const tinygltf::Accessor& accessor = model.accessors.at(std::size_t(accessor_index));
    const tinygltf::BufferView& view = model.bufferViews.at(std::size_t(accessor.bufferView));
    const std::size_t width =
        std::size_t(tinygltf::GetNumComponentsInType(unsigned(accessor.type)));
    const unsigned char* data = model.buffers.at(0).data.data() + view.byteOffset;
    std::vector<double> result;
    for (std::size_t i = 0; i < accessor.count * width; ++i) {
        if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT) {
            result.push_back(double(reinterpret_cast<const float*>(data)[i]));
        } else if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) {
            result.push_back(reinterpret_cast<const std::uint16_t*>(data)[i]);
        } else {
            result.push_back(reinterpret_cast<const std::uint32_t*>(data)[i]);
        }
    }
    return result;
}

struct Primitive {
    std::vector<double> positions, normals, uvs, indices;
};

Primitive primitive(const tinygltf::Model& model, int mesh) {
    const tinygltf::Primitive& p = model.meshes.at(std::size_t(mesh)).primitives.at(0);
    return {values(model, p.attributes.at("POSITION")), values(model, p.attributes.at("NORMAL")),
            values(model, p.attributes.at("TEXCOORD_0")), values(model, p.indices)};
}

Vec3d triple(const std::vector<double>& v, std::size_t i) {
    return {v[3 * i], v[3 * i + 1], v[3 * i + 2]};
}

Vec3d translation(const tinygltf::Node& node) {
    return node.translation.empty()
               ? Vec3d(0)
               : Vec3d(node.translation[0], node.translation[1], node.translation[2]);
}

/// Every triangle in order: its points, texture coordinates and normals are the source's.
void expect_source(const Primitive& p, const Vec3d& offset, const Mesh& mesh, const Atlas& atlas,
                   std::size_t first, std::size_t count, double position_tolerance) {
    const auto normals = corner_normals(mesh, 40.0);
    ASSERT_EQ(p.indices.size(), 3 * count);
    for (std::size_t c = 0; c < 3 * count; ++c) {
        const std::size_t t = first + c / 3, k = c % 3, v = std::size_t(p.indices[c]);
        const Vec3d point = triple(p.positions, v) + offset;
        EXPECT_LE(glm::distance(point, mesh.positions[mesh.triangles[t][k]]), position_tolerance);
        const Vec2d uv = atlas.corners[t][k] / double(atlas.options.size);
        EXPECT_EQ(p.uvs[2 * v], double(float(uv.x)));
        EXPECT_EQ(p.uvs[2 * v + 1], double(float(uv.y)));
        EXPECT_EQ(triple(p.normals, v), Vec3d(normals[3 * t + k]));
    }
}

TEST(ExportGltf, GlbHoldsTheMeshAndTheAtlas) {
    const ScratchFolder folder;
    const Mesh mesh = sphere_mesh(9, 14);
    const Atlas atlas = pair_atlas(mesh, 128);
    export_scene(folder / "a.glb", mesh, atlas, sample_image(128), {});
    EXPECT_EQ(folder.entries(), 1u);
    const tinygltf::Model model = load(folder / "a.glb");
    ASSERT_EQ(model.nodes.size(), 1u);
    EXPECT_EQ(model.nodes[0].name, "sphere");
    expect_source(primitive(model, 0), translation(model.nodes[0]), mesh, atlas, 0,
                  mesh.triangles.size(), 1e-7);
}

TEST(ExportGltf, PositionsKeepFloatPrecisionFarFromTheOrigin) {
    const ScratchFolder folder;
    for (const double offset : {1e6, 1e9}) {
        const Mesh mesh = cube_mesh(offset * Vec3d(1, -2, 3) + Vec3d(0.3, 0.1, 0.7));
        const Atlas atlas = pair_atlas(mesh, 64);
        export_scene(folder / "a.glb", mesh, atlas, sample_image(64), {});
        const tinygltf::Model model = load(folder / "a.glb");
        // The doubles themselves are 2^-52 of the offset apart.
        expect_source(primitive(model, 0), translation(model.nodes[0]), mesh, atlas, 0, 12,
                      1e-7 + 8e-16 * offset);
    }
}

TEST(ExportGltf, SizesBeyondFloatAreCarriedByTheNode) {
    const ScratchFolder folder;
    for (const double size : {1e-60, 1e60}) {
        Mesh mesh = cube_mesh();
        for (Vec3d& p : mesh.positions) p *= size;
        export_scene(folder / "a.glb", mesh, pair_atlas(mesh, 64), sample_image(64), {});
        const tinygltf::Model model = load(folder / "a.glb");
        const Primitive p = primitive(model, 0);
        for (std::size_t c = 0; c < 36; ++c) {
            const Vec3d expected = mesh.positions[mesh.triangles[c / 3][c % 3]];
            const Vec3d got =
                model.nodes[0].scale.at(0) * triple(p.positions, std::size_t(p.indices[c]));
            EXPECT_LT(glm::distance(got / size, expected / size), 1e-6);
        }
    }
}

TEST(ExportGltf, VerticesWithinAChartAreShared) {
    const ScratchFolder folder;
    const Mesh mesh = cube_mesh();
    export_scene(folder / "a.glb", mesh, pair_atlas(mesh, 64), sample_image(64), {});
    const tinygltf::Model model = load(folder / "a.glb");
    EXPECT_EQ(primitive(model, 0).positions.size(), 3u * 24u) << "four per side";
}

TEST(ExportGltf, BoundsAreThoseOfTheFloatsWritten) {
    const ScratchFolder folder;
    Mesh mesh = sphere_mesh(7, 9);
    for (Vec3d& p : mesh.positions) p = 0.1 * p + Vec3d(1.0 / 3.0);
    export_scene(folder / "a.glb", mesh, pair_atlas(mesh, 64), sample_image(64), {});
    const tinygltf::Model model = load(folder / "a.glb");
    const Primitive p = primitive(model, 0);
    const int id = model.meshes[0].primitives[0].attributes.at("POSITION");
    const tinygltf::Accessor& accessor = model.accessors[std::size_t(id)];
    for (std::size_t c = 0; c < 3; ++c) {
        double low = 1e9, high = -1e9;
        for (std::size_t i = c; i < p.positions.size(); i += 3) {
            low = std::min(low, p.positions[i]);
            high = std::max(high, p.positions[i]);
        }
        EXPECT_EQ(accessor.minValues.at(c), low);
        EXPECT_EQ(accessor.maxValues.at(c), high);
    }
}

TEST(ExportGltf, IndicesAreAsNarrowAsTheyMayBe) {
    const ScratchFolder folder;
    const auto component = [&](std::uint32_t rings) {
        const Mesh mesh = sphere_mesh(rings, 100);
        export_scene(folder / "a.glb", mesh, pair_atlas(mesh, 512), sample_image(512), {});
        const tinygltf::Model model = load(folder / "a.glb");
        return model.accessors[std::size_t(model.meshes[0].primitives[0].indices)].componentType;
    };
    EXPECT_EQ(component(20), TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT);
    EXPECT_EQ(component(300), TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
}

TEST(ExportGltf, TextureMaterialAndSamplerAreAsDocumented) {
    const ScratchFolder folder;
    const Mesh mesh = cube_mesh();
    const Image<Rgb8> image = sample_image(64);
    for (const Overscan overscan : {Overscan::nearest, Overscan::bilinear}) {
        const Atlas atlas = pair_atlas(mesh, 64, overscan);
        export_scene(folder / "a.glb", mesh, atlas, image, {.recipe_json = R"({"burl":1})"});
        const tinygltf::Model model = load(folder / "a.glb");
        const tinygltf::Image& stored = model.images.at(0);
        EXPECT_EQ(stored.mimeType, "image/png");
        EXPECT_GE(stored.bufferView, 0);
        EXPECT_EQ(decode_png(stored.image, "embedded"), image);
        const auto& pbr = model.materials.at(0).pbrMetallicRoughness;
        EXPECT_EQ(pbr.baseColorTexture.index, 0);
        EXPECT_EQ(pbr.metallicFactor, 0.0);
        const tinygltf::Sampler& sampler = model.samplers.at(0);
        const int filter = overscan == Overscan::nearest ? TINYGLTF_TEXTURE_FILTER_NEAREST
                                                         : TINYGLTF_TEXTURE_FILTER_LINEAR;
        EXPECT_EQ(sampler.magFilter, filter);
        EXPECT_EQ(sampler.minFilter, filter);
        EXPECT_EQ(sampler.wrapS, TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE);
        EXPECT_EQ(sampler.wrapT, TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE);
        EXPECT_EQ(model.asset.generator.substr(0, 5), "Burl ");
        const tinygltf::Value& extras = model.asset.extras.Get("burl");
        EXPECT_EQ(extras.Get("recipe").Get<std::string>(), R"({"burl":1})");
        EXPECT_EQ(extras.Get("size").GetNumberAsInt(), 64);
    }
}

TEST(ExportGltf, MaterialAndImagesAreCalledAfterMeshAndRecipe) {
    const ScratchFolder folder;
    const Mesh mesh = cube_mesh();
    ExportOptions options;
    options.recipe_name = "sea ice";
    options.levels = {BakedImage(sample_image(32))};
    options.normals = NormalMap{sample_image(64)};
    for (const char* file : {"a.glb", "a.gltf"}) {
        export_scene(folder / file, mesh, pair_atlas(mesh, 64), sample_image(64), options);
        const tinygltf::Model model = load(folder / file);
        EXPECT_EQ(model.materials.at(0).name, "cube sea ice");
        ASSERT_EQ(model.images.size(), 3u);
        EXPECT_EQ(model.images[0].name, "cube sea ice");
        EXPECT_EQ(model.images[1].name, "cube sea ice level 1");
        EXPECT_EQ(model.images[2].name, "cube sea ice normals");
    }
}

/// The names of nodes where so many parts are called "Cube" and one "Cube 3".
std::vector<std::string> node_names(const ScratchFolder& folder, std::size_t count) {
    Mesh mesh = cube_mesh();
    mesh.parts = {{"Cube 3", 0, 1, {Mat4d(1.0)}}};
    for (std::uint32_t i = 1; i < 12; ++i) mesh.parts.push_back({"Cube", i, 1, {Mat4d(1.0)}});
    mesh.parts.back().instances.resize(count - 11, Mat4d(1.0));
    export_scene(folder / "a.gltf", mesh, pair_atlas(mesh, 64), sample_image(64), {});
    std::vector<std::string> names;
    for (const tinygltf::Node& node : load(folder / "a.gltf").nodes) names.push_back(node.name);
    return names;
}

TEST(ExportGltf, ManyPlacementsOfOneNameGetNumbersInALittleTime) {
    const ScratchFolder folder;
    const std::vector<std::string> few = node_names(folder, 12);
    EXPECT_EQ(few, (std::vector<std::string>{"Cube 3", "Cube", "Cube 2", "Cube 4", "Cube 5",
                                             "Cube 6", "Cube 7", "Cube 8", "Cube 9", "Cube 10",
                                             "Cube 11", "Cube 12"}));
    EXPECT_EQ(node_names(folder, 20000).back(), "Cube 20000");
    const auto time = [&](std::size_t count) {
        return test::cpu_time([&] { node_names(folder, count); });
    };
    EXPECT_LT(time(20000), 24 * time(2500)) << "8 times as many, which were 64 times the pairs";
}

TEST(ExportGltf, PlacementsBeyondFloatsAreRefused) {
    const ScratchFolder folder;
    Mesh mesh = cube_mesh();
    const Mat4d sheared = placement(0, Vec3d(1, 1e60, 1), {}) * placement(45, Vec3d(1), {});
    mesh.parts[0].instances.push_back(sheared);
    for (const char* file : {"a.glb", "a.gltf"}) {
        try {
            export_scene(folder / file, mesh, pair_atlas(mesh, 64), sample_image(64), {});
            ADD_FAILURE() << file;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::unsupported);
            EXPECT_THAT(error.what(), testing::HasSubstr("a placement of \"cube\""));
        }
    }
    EXPECT_EQ(folder.entries(), 0u);
    export_scene(folder / "a.obj", mesh, pair_atlas(mesh, 64), sample_image(64), {});
}

TEST(ExportGltf, PartsAndPlacementsBecomeMeshesAndNodes) {
    const ScratchFolder folder;
    Mesh mesh = cube_mesh(Vec3d(5, 0, 0));
    const Mat4d moved = placement(30, Vec3d(1, 1, -2), {1, 2, 3});
    const Mat4d sheared = placement(0, Vec3d(1, 4, 1), {}) * placement(45, Vec3d(1), {0, 1, 0});
    mesh.parts = {{"leg", 0, 4, {Mat4d(1.0), moved}},
                  {"leg", 4, 8, {Mat4d(1.0), sheared}},
                  {"nothing", 12, 0, {Mat4d(1.0)}}};
    const Atlas atlas = pair_atlas(mesh, 64);
    export_scene(folder / "a.glb", mesh, atlas, sample_image(64), {});
    const tinygltf::Model model = load(folder / "a.glb");
    ASSERT_EQ(model.nodes.size(), 4u);
    ASSERT_EQ(model.meshes.size(), 3u) << "one more for the sheared placement";
    EXPECT_EQ(model.nodes[0].name, "leg");
    EXPECT_EQ(model.nodes[1].name, "leg 2");
    EXPECT_EQ(model.nodes[0].mesh, model.nodes[1].mesh);
    expect_source(primitive(model, 0), translation(model.nodes[0]), mesh, atlas, 0, 4, 1e-6);
    expect_source(primitive(model, 1), translation(model.nodes[2]), mesh, atlas, 4, 8, 1e-6);
    const Primitive shear = primitive(model, model.nodes[3].mesh);
    for (std::size_t c = 0; c < 24; ++c) {
        const Vec3d source = mesh.positions[mesh.triangles[4 + c / 3][c % 3]];
        const Vec3d got =
            triple(shear.positions, std::size_t(shear.indices[c])) + translation(model.nodes[3]);
        EXPECT_LT(glm::distance(got, Vec3d(sheared * Vec4d(source, 1))), 1e-5);
    }
    const Primitive leg = primitive(model, 0);
    const tinygltf::Node& node = model.nodes[1];
    const Vec3d u(node.rotation.at(0), node.rotation.at(1), node.rotation.at(2));
    for (std::size_t c = 0; c < 12; ++c) {
        const Vec3d p = Vec3d(node.scale.at(0), node.scale.at(1), node.scale.at(2)) *
                        triple(leg.positions, std::size_t(leg.indices[c]));
        const Vec3d got =
            p + 2.0 * glm::cross(u, glm::cross(u, p) + node.rotation.at(3) * p) + translation(node);
        const Vec3d source = mesh.positions[mesh.triangles[c / 3][c % 3]];
        EXPECT_LT(glm::distance(got, Vec3d(moved * Vec4d(source, 1))), 1e-5);
    }
}

TEST(ExportGltf, TextFormHasItsFilesBesideIt) {
    const ScratchFolder folder;
    const Mesh mesh = cube_mesh();
    const Atlas atlas = pair_atlas(mesh, 64);
    export_scene(folder / "two words.gltf", mesh, atlas, sample_image(64), {});
    EXPECT_EQ(folder.entries(), 3u);
    const tinygltf::Model model = load(folder / "two words.gltf");
    EXPECT_EQ(model.images.at(0).uri, "two%20words.png");
    EXPECT_EQ(read_png(folder / "two words.png"), sample_image(64));
    expect_source(primitive(model, 0), translation(model.nodes[0]), mesh, atlas, 0, 12, 1e-7);
}

}  // namespace
}  // namespace burl
