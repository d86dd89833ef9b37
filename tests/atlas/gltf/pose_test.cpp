// Poses of a glTF's own skeletons and animations, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "atlas/base/json.h"
#include "atlas/read/pose.h"
#include "tests/atlas/support/gltf_files.h"
#include "tests/cpu_time.h"

namespace burl {
namespace {

using test::expect_error;
using test::GltfFile;

const double half_root = std::sqrt(0.5);

MeshPose pose_of(const GltfFile& file, const std::string& name) {
    const std::string text = file.gltf();
    return read_own_pose(buffer_from(text, "m.gltf"), name);
}

std::vector<std::string> names_of(const GltfFile& file) {
    const std::string text = file.gltf();
    return pose_names(buffer_from(text, "m.gltf"));
}

void expect_near(const Vec3d& p, const Vec3d& q) {
    EXPECT_LT(glm::distance(p, q), 1e-6)
        << p.x << " " << p.y << " " << p.z << " instead of " << q.x << " " << q.y << " " << q.z;
}

/// Three points (0,0,0), (1,0,0) and (2,1,0) that follow the shoulder, both joints and the elbow,
/// which is at (1,0,0); the mesh's own node is elsewhere, which does not count.
GltfFile arm() {
    GltfFile file;
    const int position = file.positions({0, 0, 0, 1, 0, 0, 2, 1, 0});
    const int normal = file.positions({0, 0, 1, 1, 0, 0, 1, 0, 0});
    const int joints = file.accessor(
        file.view(GltfFile::packed(std::vector<std::uint8_t>{0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0})),
        5121, "VEC4", 3);
    const int weights = file.floats({1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 0, 1, 0, 0}, "VEC4", 4);
    file.mesh({{"attributes",
                {{"POSITION", position},
                 {"NORMAL", normal},
                 {"JOINTS_0", joints},
                 {"WEIGHTS_0", weights}}},
               {"indices", file.shorts({0, 1, 2})}});
    file.node({{"mesh", 0}, {"skin", 0}, {"translation", {7, 7, 7}}});
    file.node({{"children", {2}}, {"translation", {0, 0, 3}}});
    file.node({{"translation", {1, 0, 0}}, {"rotation", {0, 0, half_root, half_root}}});
    const int inverse = file.floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,
                                     1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1},
                                    "MAT4", 16);
    file.root["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", inverse}}};
    return file;
}

/// One channel with keys at 1 and 3 s.
GltfFile animated(GltfFile file, int node, const std::string& path, const std::string& how,
                  const std::vector<float>& values, const std::string& type, std::size_t width) {
    const int input = file.floats({1, 3}, "SCALAR", 1);
    const int output = file.floats(values, type, width);
    file.root["animations"] = {
        {{"name", "wave"},
         {"samplers", {{{"input", input}, {"output", output}, {"interpolation", how}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}}}}};
    return file;
}

TEST(GltfPose, VerticesFollowTheirJoints) {
    EXPECT_EQ(names_of(arm()), std::vector<std::string>{"nodes"});
    const MeshPose pose = pose_of(arm(), "nodes");
    ASSERT_EQ(pose.positions.size(), 3u);
    expect_near(pose.positions[0], {0, 0, 3});
    expect_near(pose.positions[1], {1, 0, 3});  // the elbow itself
    expect_near(pose.positions[2], {0, 1, 3});  // (1,1) about the elbow, a quarter turn on
    expect_near(pose.normals[0], {0, 0, 1});
    expect_near(pose.normals[1], {half_root, half_root, 0});  // half-way between x and y
    expect_near(pose.normals[2], {0, 1, 0});
    // The mesh itself is as it is stored.
    const Mesh mesh = arm().read();
    expect_near(mesh.positions[2], {2, 1, 0});
}

TEST(GltfPose, KeysAreJoinedByTheShorterTurn) {
    // From no turn to a quarter about z, given as its negative.
    const GltfFile file =
        animated(arm(), 2, "rotation", "LINEAR",
                 {0, 0, 0, 1, 0, 0, -float(half_root), -float(half_root)}, "VEC4", 4);
    const double angle = std::acos(-1.0) / 4.0;  // half-way
    const Vec3d turned(1 + std::cos(angle) - std::sin(angle), std::sin(angle) + std::cos(angle), 3);
    expect_near(pose_of(file, "wave@2").positions[2], turned);
    expect_near(pose_of(file, "wave@0").positions[2], {2, 1, 3});
    expect_near(pose_of(file, "wave@99").positions[2], {0, 1, 3});
}

TEST(GltfPose, StepsStayAndCubicKeysFollowTheirTangents) {
    const std::vector<float> two{4, 0, 0, 8, 0, 0};
    expect_near(
        pose_of(animated(arm(), 1, "translation", "STEP", two, "VEC3", 3), "wave@2.9").positions[0],
        {4, 0, 0});
    expect_near(pose_of(animated(arm(), 1, "translation", "LINEAR", two, "VEC3", 3), "wave@1.5")
                    .positions[0],
                {5, 0, 0});
    // x(t) = t^3 has the tangents 3 t^2: the cubic is that curve.
    const GltfFile cubic =
        animated(arm(), 1, "translation", "CUBICSPLINE",
                 {0, 0, 0, 1, 0, 0, 3, 0, 0, 27, 0, 0, 27, 0, 0, 0, 0, 0}, "VEC3", 3);
    for (const double t : {1.0, 1.5, 2.25, 3.0})
        expect_near(pose_of(cubic, fmt::format("wave@{}", t)).positions[0], {t * t * t, 0, 0});
}

/// A triangle with a target of a node that moves it.
GltfFile moved() {
    GltfFile file;
    const int position = file.positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int up = file.positions({0, 0, 2, 0, 0, 0, 0, 0, 0});
    file.mesh({{"attributes", {{"POSITION", position}}}, {"targets", {{{"POSITION", up}}}}});
    file.node({{"mesh", 0}, {"translation", {5, 0, 0}}});
    return file;
}

TEST(GltfPose, AnimationsMoveMeshesWithoutASkinAndMorphTargets) {
    const GltfFile lifted = animated(moved(), 0, "scale", "LINEAR", {1, 1, 1, 3, 3, 3}, "VEC3", 3);
    const MeshPose scaled = pose_of(lifted, "wave@2");
    expect_near(scaled.positions[1], {7, 0, 0});
    expect_near(scaled.positions[2], {5, 2, 0});
    const GltfFile morphed = animated(moved(), 0, "weights", "LINEAR", {0, 1}, "SCALAR", 1);
    expect_near(pose_of(morphed, "wave@1.5").positions[0], {5, 0, 0.5});
    expect_near(pose_of(morphed, "0").positions[0], {5, 0, 2});
}

TEST(GltfPose, FiveMomentsOfAnAnimationAreNamed) {
    const GltfFile file = animated(moved(), 0, "weights", "LINEAR", {0, 1}, "SCALAR", 1);
    EXPECT_EQ(names_of(file), (std::vector<std::string>{"0", "wave@0", "wave@0.75", "wave@1.5",
                                                        "wave@2.25", "wave@3"}));
    for (const std::string& name : names_of(file)) EXPECT_EQ(pose_of(file, name).name, name);
}

TEST(GltfPose, WhatIsWrongIsSaid) {
    const GltfFile file =
        animated(arm(), 1, "translation", "LINEAR", {4, 0, 0, 8, 0, 0}, "VEC3", 3);
    for (const char* name : {"wave", "wave@", "wave@x", "wave@1 ", "walk@1", "wave@nan"})
        expect_error([&] { pose_of(file, name); }, ExitCode::usage, "nodes, wave@0, wave@0.75");
    expect_error([&] { pose_of(moved(), "nodes"); }, ExitCode::usage, "those of the file are 0");
    const GltfFile few = animated(arm(), 1, "translation", "LINEAR", {4, 0, 0}, "VEC3", 3);
    expect_error([&] { pose_of(few, "wave@1"); }, ExitCode::invalid_file, "do not fit");
    GltfFile lame = arm();
    lame.root["skins"][0]["joints"] = {1};
    expect_error([&] { pose_of(lame, "nodes"); }, ExitCode::invalid_file, "follows joint 1");
    GltfFile flat = arm();
    flat.root["skins"][0]["inverseBindMatrices"] = 0;
    expect_error([&] { pose_of(flat, "nodes"); }, ExitCode::invalid_file, "MAT4");
}

/// So many targets of one mesh.
GltfFile with_targets(int count) {
    GltfFile file = moved();
    auto& targets = file.root["meshes"][0]["primitives"][0]["targets"];
    targets = GltfFile::Json(std::size_t(count), targets[0]);
    return file;
}

TEST(GltfPose, ManyTargetsAreNamedInOnePassAndAFewOfThemInMessages) {
    constexpr int count = 50000;
    const GltfFile file = with_targets(count), few = with_targets(count / 8);
    EXPECT_EQ(names_of(file).size(), std::size_t(count));
    expect_error([&] { pose_of(file, "no"); }, ExitCode::usage, "those of the file are 0, 1, 2, ");
    expect_error([&] { pose_of(file, "no"); }, ExitCode::usage, ", 98, 99 and 49900 more");
    EXPECT_LT(test::cpu_time([&] { names_of(file); }), 24 * test::cpu_time([&] { names_of(few); }));
}

/// So many samplers of one animation that share their keys.
GltfFile with_samplers(int count) {
    GltfFile file = animated(moved(), 0, "translation", "LINEAR", {4, 0, 0, 8, 0, 0}, "VEC3", 3);
    std::vector<float> seconds(200000);
    for (std::size_t i = 0; i < seconds.size(); ++i) seconds[i] = float(i);
    const int times = file.floats(seconds, "SCALAR", 1);
    const GltfFile::Json sampler{{"input", times}, {"output", times}};
    for (int i = 0; i < count; ++i) file.root["animations"][0]["samplers"].push_back(sampler);
    return file;
}

TEST(GltfPose, KeysThatSamplersShareAreReadOnce) {
    const GltfFile file = with_samplers(5000), one = with_samplers(1);
    EXPECT_EQ(names_of(file).back(), "wave@199999");
    EXPECT_LT(test::cpu_time([&] { names_of(file); }), 24 * test::cpu_time([&] { names_of(one); }));
}

}  // namespace
}  // namespace burl
