// glTF: scenes, transforms, instances, primitive modes and accessors against values worked out by
// hand.

#include "atlas/base/json.h"
#include "tests/atlas/support/gltf_files.h"

namespace burl {
namespace {

using test::corner;
using test::GltfFile;
using Json = nlohmann::json;

void gltf_expect_near(const Vec3d& a, const Vec3d& b) {
    EXPECT_NEAR(glm::distance(a, b), 0.0, 1e-12) << a.x << ' ' << a.y << ' ' << a.z;
}

Vec3d normal_of(const Mesh& mesh, std::size_t t) {
    return glm::cross(corner(mesh, t, 1) - corner(mesh, t, 0),
                      corner(mesh, t, 2) - corner(mesh, t, 0));
}

TEST(ReadGltf, TransformsOfNestedNodes) {
    GltfFile file;
    const int mesh = file.triangle();
    // 90 degrees about z, then x doubled: (x, y, z) -> (-y * 2 + 10, x, z)
    const double h = std::sqrt(0.5);
    file.node({{"mesh", mesh}, {"rotation", {0, 0, h, h}}});
    file.node({{"children", {0}}, {"scale", {2, 1, 1}}});
    file.node({{"children", {1}}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10, 0, 0, 1}}});
    const Mesh read = file.read();
    gltf_expect_near(corner(read, 0, 0), {10, 0, 0});
    gltf_expect_near(corner(read, 0, 1), {10, 1, 0});
    gltf_expect_near(corner(read, 0, 2), {8, 0, 0});
}

TEST(ReadGltf, WhichScene) {
    GltfFile file;
    file.triangle();
    for (int i = 0; i < 3; ++i) file.node({{"mesh", 0}, {"translation", {i, 0, 0}}});
    EXPECT_EQ(file.read().parts[0].instances.size(), 3u);  // no scene: all roots
    file.root["scenes"] = {{{"nodes", {1}}}, {{"nodes", {2, 0}}}};
    EXPECT_EQ(corner(file.read(), 0, 0), Vec3d(1, 0, 0));  // none named: the first
    file.root["scene"] = 1;
    const Mesh second = file.read();
    EXPECT_EQ(corner(second, 0, 0), Vec3d(2, 0, 0));
    EXPECT_EQ(second.parts[0].instances.size(), 2u);
}

TEST(ReadGltf, MirroringTurnsTheWinding) {
    GltfFile file;
    const int normals = file.floats({0, 0, 1, 0, 0, 1, 1, 1, 0}, "VEC3", 3);
    const int mesh = file.triangle();
    file.root["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = normals;
    file.node({{"mesh", mesh}, {"scale", {-2, 1, 1}}});
    const Mesh read = file.read();
    gltf_expect_near(normal_of(read, 0), {0, 0, 2});
    EXPECT_EQ(read.corners.normals[0], Vec3f(0, 0, 1));
    // Corner 2 came to place 1; its normal follows the inverse transposed: (-1/2, 1, 0).
    gltf_expect_near(Vec3d(read.corners.normals[1]) * std::sqrt(1.25) / 1.0,
                     Vec3d(Vec3f(glm::normalize(Vec3d(-0.5, 1, 0)))) * std::sqrt(1.25));
    EXPECT_EQ(corner(read, 0, 1), Vec3d(0, 1, 0));
}

TEST(ReadGltf, InstancesStandWhereTheirNodesStand) {
    GltfFile file;
    const int mesh = file.triangle();
    file.root["meshes"][0]["name"] = "leaf";
    file.node({{"mesh", mesh}, {"translation", {5, 0, 0}}, {"scale", {2, 2, 2}}});
    file.node({{"mesh", mesh}, {"translation", {0, 7, 0}}, {"scale", {3, 1, 1}}});
    const Mesh shared = file.read();
    ASSERT_EQ(shared.triangles.size(), 1u);
    ASSERT_EQ(shared.parts.size(), 1u);
    EXPECT_EQ(shared.parts[0].name, "leaf");
    ASSERT_EQ(shared.parts[0].instances.size(), 2u);
    EXPECT_EQ(shared.parts[0].instances[0], Mat4d(1.0));
    EXPECT_EQ(corner(shared, 0, 1), Vec3d(7, 0, 0));
    gltf_expect_near(Vec3d(shared.parts[0].instances[1] * Vec4d(corner(shared, 0, 1), 1.0)),
                     {3, 7, 0});

    const Mesh copies = file.read({.unshare_instances = true});
    ASSERT_EQ(copies.triangles.size(), 2u);
    ASSERT_EQ(copies.parts.size(), 2u);
    EXPECT_EQ(copies.parts[1].first_triangle, 1u);
    EXPECT_EQ(copies.parts[1].instances.size(), 1u);
    EXPECT_EQ(corner(copies, 1, 1), Vec3d(3, 7, 0));
    EXPECT_EQ(copies.source_faces, (std::vector<std::uint32_t>{0, 0}));
}

TEST(ReadGltf, AFlattenedFirstInstanceIsNotShared) {
    GltfFile file;
    file.triangle();
    file.node({{"mesh", 0}, {"scale", {1, 1, 0}}});
    file.node({{"mesh", 0}, {"translation", {0, 0, 4}}});
    const Mesh mesh = file.read();
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(corner(mesh, 1, 0), Vec3d(0, 0, 4));
}

TEST(ReadGltf, TwoMeshesAreTwoParts) {
    GltfFile file;
    const int points = file.positions({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
    file.mesh(
        {{"attributes", {{"POSITION", points}}}, {"indices", file.shorts({0, 1, 2, 2, 1, 3})}});
    file.triangle();
    file.triangle();
    file.node({{"mesh", 1}});
    file.node({{"mesh", 0}});
    const Mesh mesh = file.read();
    ASSERT_EQ(mesh.parts.size(), 2u);
    EXPECT_EQ(mesh.parts[0].name, "mesh 1");
    EXPECT_EQ(mesh.parts[0].triangle_count, 1u);
    EXPECT_EQ(mesh.parts[1].first_triangle, 1u);
    EXPECT_EQ(mesh.parts[1].triangle_count, 2u);
    EXPECT_EQ(mesh.source_faces, (std::vector<std::uint32_t>{0, 1, 2}));
    ASSERT_EQ(mesh.notes.sentences.size(), 1u);
    EXPECT_NE(mesh.notes.sentences[0].find("1 meshes are not in"), std::string::npos);
}

TEST(ReadGltf, StripsAndFansKeepTheirFront) {
    for (const int mode : {5, 6}) {
        GltfFile file;
        const std::vector<float> strip{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0};
        const std::vector<float> fan{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, -1, 1, 0};
        const int points = file.positions(mode == 5 ? strip : fan);
        file.mesh({{"attributes", {{"POSITION", points}}}, {"mode", mode}});
        file.node({{"mesh", 0}});
        const Mesh mesh = file.read();
        ASSERT_EQ(mesh.triangles.size(), 3u);
        EXPECT_DOUBLE_EQ(test::total_area(mesh), 1.5);
        for (std::size_t t = 0; t < 3; ++t)
            EXPECT_GT(normal_of(mesh, t).z, 0.0) << mode << ' ' << t;
    }
}

TEST(ReadGltf, StripStitchesAreLeftOutAndSaid) {
    GltfFile file;
    const int points = file.positions({0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0});
    file.mesh({{"attributes", {{"POSITION", points}}},
               {"indices", file.shorts({0, 1, 2, 2, 2, 3, 3, 4, 5})},
               {"mode", 5}});
    file.node({{"mesh", 0}});
    const Mesh mesh = file.read();
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_GT(normal_of(mesh, 0).z, 0.0);
    EXPECT_GT(normal_of(mesh, 1).z, 0.0);
    ASSERT_EQ(mesh.notes.sentences.size(), 1u);
    EXPECT_NE(mesh.notes.sentences[0].find("5 triangles"), std::string::npos);
}

TEST(ReadGltf, PointsAndLinesAreCounted) {
    GltfFile file;
    file.triangle();
    const Json attributes{{"POSITION", 0}};
    for (int mode = 0; mode < 4; ++mode)
        file.root["meshes"][0]["primitives"].push_back(
            {{"attributes", attributes}, {"mode", mode}});
    file.root["meshes"][0]["primitives"].push_back({{"attributes", Json::object()}});
    file.node({{"mesh", 0}});
    EXPECT_EQ(file.read().notes.ignored_elements, 3u + 1u + 3u + 2u + 1u);
}

TEST(ReadGltf, IndexTypesStridesAndNormalizedIntegers) {
    GltfFile file;
    // Positions as shorts (KHR_mesh_quantization) with a stride, uvs and colours normalized.
    const std::string rows =
        GltfFile::packed<std::int16_t>({0, 0, 0, 9, 100, 0, 0, 9, 0, 200, 0, 9});
    file.root["extensionsRequired"] = {"KHR_mesh_quantization"};
    const int points = file.accessor(file.view(rows, 8), 5122, "VEC3", 3);
    const int uvs =
        file.accessor(file.view(GltfFile::packed<std::uint16_t>({0, 65535, 13107, 0, 0, 0})), 5123,
                      "VEC2", 3, {{"normalized", true}});
    const int colors = file.accessor(
        file.view(GltfFile::packed<std::uint8_t>({255, 0, 51, 0, 0, 0, 0, 0, 0, 0, 0, 0}), 4), 5121,
        "VEC3", 3, {{"normalized", true}});
    const int indices = file.accessor(file.view(GltfFile::packed<std::uint32_t>({77, 2, 1, 0})),
                                      5125, "SCALAR", 3, {{"byteOffset", 4}});
    file.mesh({{"attributes", {{"POSITION", points}, {"TEXCOORD_0", uvs}, {"COLOR_0", colors}}},
               {"indices", indices}});
    file.node({{"mesh", 0}});
    const Mesh mesh = file.read();
    EXPECT_EQ(corner(mesh, 0, 0), Vec3d(0, 200, 0));
    EXPECT_EQ(corner(mesh, 0, 1), Vec3d(100, 0, 0));
    EXPECT_EQ(mesh.corners.uvs[2], Vec2d(0, 1));
    EXPECT_DOUBLE_EQ(mesh.corners.uvs[1].x, 0.2);
    EXPECT_FLOAT_EQ(mesh.corners.colors[2].b, 0.2f);
    EXPECT_EQ(mesh.corners.colors[2].a, 1.0f);
}

TEST(ReadGltf, SparseAccessors) {
    GltfFile file;
    const int base = file.view(GltfFile::packed<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    const int which = file.view(GltfFile::packed<std::uint8_t>({1, 2}));
    const int values = file.view(GltfFile::packed<float>({4, 0, 0, 0, 5, 6}));
    const Json sparse{{"sparse",
                       {{"count", 2},
                        {"indices", {{"bufferView", which}, {"componentType", 5121}}},
                        {"values", {{"bufferView", values}}}}}};
    file.mesh({{"attributes", {{"POSITION", file.accessor(base, 5126, "VEC3", 3, sparse)}}}});
    file.mesh({{"attributes", {{"POSITION", file.accessor(-1, 5126, "VEC3", 3, sparse)}}}});
    file.node({{"mesh", 0}});
    file.node({{"mesh", 1}});
    const Mesh mesh = file.read();
    for (std::size_t t = 0; t < 2; ++t) {
        EXPECT_EQ(corner(mesh, t, 0), Vec3d(0, 0, 0));
        EXPECT_EQ(corner(mesh, t, 1), Vec3d(4, 0, 0));
        EXPECT_EQ(corner(mesh, t, 2), Vec3d(0, 5, 6));
    }
}

TEST(ReadGltf, AttributesOfOnePrimitiveOnly) {
    GltfFile file;
    file.triangle();
    const int points = file.positions({0, 0, 1, 1, 0, 1, 0, 1, 1});
    const int uvs = file.floats({0.1f, 0, 0.2f, 0, 0.3f, 0}, "VEC2", 2);
    file.root["meshes"][0]["primitives"].push_back(
        {{"attributes", {{"POSITION", points}, {"TEXCOORD_0", uvs}}}});
    file.root["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", points}}}});
    file.node({{"mesh", 0}});
    const Mesh mesh = file.read();
    ASSERT_EQ(mesh.corners.uvs.size(), 9u);
    EXPECT_EQ(mesh.corners.uvs[0], Vec2d(0.0));
    EXPECT_EQ(mesh.corners.uvs[4], Vec2d(double(0.2f), 0.0));
    EXPECT_EQ(mesh.corners.uvs[8], Vec2d(0.0));
}

TEST(ReadGltf, SkinnedMeshesStandInBindPose) {
    GltfFile file;
    file.triangle();
    auto& attributes = file.root["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = file.accessor(
        file.view(GltfFile::packed<std::uint8_t>({1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0})), 5121,
        "VEC4", 3);
    attributes["WEIGHTS_0"] = file.floats({2, 2, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}, "VEC4", 4);
    file.node({{"mesh", 0}, {"skin", 0}, {"translation", {50, 0, 0}}});
    file.node({{"name", "a"}});
    file.node({{"name", "b"}});
    file.root["skins"] = {{{"joints", {1, 2}}}};
    const Mesh mesh = file.read();
    EXPECT_EQ(corner(mesh, 0, 1), Vec3d(1, 0, 0));  // the node's own transform does not count
    EXPECT_EQ(mesh.corners.joints[0][0], 1);
    EXPECT_EQ(mesh.corners.weights[0], Vec4f(0.5f, 0.5f, 0.0f, 0.0f));
    EXPECT_EQ(mesh.corners.weights[2], Vec4f(1.0f, 0.0f, 0.0f, 0.0f));
}

TEST(ReadGltf, GlbAndSeparateBuffers) {
    GltfFile file;
    file.triangle();
    file.node({{"mesh", 0}});
    EXPECT_EQ(test::read_text("a.glb", file.glb()).triangles.size(), 1u);
    EXPECT_EQ(test::read_text("swapped.gltf", file.glb()).triangles.size(), 1u);  // told by content
    test::write_file("some data.bin", file.binary + "padding");
    file.root["buffers"] = {{{"byteLength", file.binary.size()}, {"uri", "some%20data.bin"}}};
    EXPECT_EQ(file.read().triangles.size(), 1u);
}

TEST(ReadGltf, WeldsSeamsAndKeepsAttributes) {
    GltfFile file;
    const int points = file.positions({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    file.mesh({{"attributes", {{"POSITION", points}}}});
    file.node({{"mesh", 0}});
    const Mesh mesh = file.read();
    EXPECT_EQ(mesh.positions.size(), 4u);
    EXPECT_EQ(mesh.notes.merged_points, 2u);
}

TEST(ReadGltf, InstancesLieWherePointsMay) {
    test::expect_error([] { read_mesh(test::case_file("i2.gltf")); }, ExitCode::invalid_file,
                       "nodes[1]: the positions of its mesh are not finite, or beyond 1e100");
    GltfFile file;
    file.triangle();
    file.node({{"mesh", 0}});
    file.node({{"mesh", 0}, {"scale", {1e99, 1, 1}}});
    EXPECT_EQ(file.read().parts.at(0).instances.size(), 2u);
    file.root["nodes"][1]["scale"] = {1e101, 1, 1};
    test::expect_error([&] { file.read(); }, ExitCode::invalid_file, "nodes[1]: the positions");
}

}  // namespace
}  // namespace burl
