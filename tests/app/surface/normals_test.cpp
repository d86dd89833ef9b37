// Normals against closed forms: the cube's, the sphere's, and a corner's whatever its tessellation.
#include "app/surface/normals.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

Vec3d flat_normal(const Mesh& mesh, std::size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto& p = mesh.positions;
    return glm::normalize(glm::cross(p[b] - p[a], p[c] - p[a]));
}

double angle_between(const Vec3d& a, const Vec3d& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

void expect_unit(const std::vector<Vec3f>& normals) {
    for (const Vec3f& n : normals) EXPECT_NEAR(glm::length(Vec3d(n)), 1.0, 1e-6);
}

TEST(Normals, ACubeIsFlatBelowItsCreaseAngle) {
    const Mesh mesh = cube_mesh(Vec3d(1e6, -3, 0.1));
    for (const double crease : {0.0, 40.0, 89.9}) {
        const auto normals = corner_normals(mesh, crease);
        ASSERT_EQ(normals.size(), 36u);
        for (std::size_t c = 0; c < 36; ++c) {
            EXPECT_LT(glm::length(Vec3d(normals[c]) - flat_normal(mesh, c / 3)), 1e-6) << crease;
        }
    }
}

TEST(Normals, ACubeIsRoundAboveIt) {
    // Each corner's three sides have a right angle there, however their diagonals lie: the weighted
    // mean is the space diagonal. Plain averages of triangles would miss it.
    const Mesh mesh = cube_mesh();
    const auto normals = corner_normals(mesh, 100.0);
    for (std::size_t c = 0; c < 36; ++c) {
        const Vec3d corner = mesh.positions[mesh.triangles[c / 3][c % 3]];
        EXPECT_LT(angle_between(Vec3d(normals[c]), corner), 1e-6);
    }
}

TEST(Normals, ASphereHasItsOwn) {
    const Mesh mesh = sphere_mesh(48, 96);
    const auto normals = corner_normals(mesh, 40.0);
    expect_unit(normals);
    for (std::size_t c = 0; c < normals.size(); ++c) {
        const Vec3d analytic = mesh.positions[mesh.triangles[c / 3][c % 3]];
        EXPECT_LT(angle_between(Vec3d(normals[c]), analytic), 0.01);
    }
}

TEST(Normals, AllCornersOfASmoothPointAgreeInEveryBit) {
    const Mesh mesh = sphere_mesh(8, 12);  // 30 degrees from face to face, far more around a point
    const auto normals = corner_normals(mesh, 40.0);
    std::vector<Vec3f> of_point(mesh.positions.size(), Vec3f(0.0f));
    for (std::size_t c = 0; c < normals.size(); ++c) {
        Vec3f& known = of_point[mesh.triangles[c / 3][c % 3]];
        if (known == Vec3f(0.0f)) known = normals[c];
        EXPECT_EQ(known, normals[c]);
    }
}

TEST(Normals, TessellationOfASideDoesNotMatter) {
    // The apex of three square sides, one of which is cut into ever more triangles.
    for (const int cuts : {1, 2, 7, 50}) {
        Mesh mesh;
        mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
        mesh.triangles = {{0, 1, 2}};  // y = 0, facing -y
        std::uint32_t previous = 1;
        for (int i = 1; i <= cuts; ++i) {  // z = 0, facing -z, from the x to the y axis
            const double turn = 0.5 * std::numbers::pi * i * i / (cuts * cuts);  // uneven slices
            mesh.positions.push_back({std::cos(turn), std::sin(turn), 0});
            const auto next = std::uint32_t(mesh.positions.size() - 1);
            mesh.triangles.push_back({0, next, previous});
            previous = next;
        }
        mesh.triangles.push_back({0, 2, previous});  // x = 0, facing -x
        add_whole_part(mesh);
        const auto normals = corner_normals(mesh, 180.0);
        EXPECT_LT(angle_between(Vec3d(normals[0]), Vec3d(-1, -1, -1)), 1e-6) << cuts;
    }
}

TEST(Normals, OnlyTheCreaseItselfIsSplit) {
    // A tent: two slopes of two triangles each, 60 degrees apart; smooth within, split along the
    // top.
    Mesh mesh;
    const double h = std::tan(std::numbers::pi / 6);
    mesh.positions = {{-1, 0, 0}, {-1, 1, 0}, {0, 0, h}, {0, 1, h}, {1, 0, 0}, {1, 1, 0}};
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}};
    add_whole_part(mesh);
    const auto split = corner_normals(mesh, 59.0), joined = corner_normals(mesh, 61.0);
    const Vec3d left(-0.5, 0, std::sqrt(0.75)), right(0.5, 0, std::sqrt(0.75));
    for (std::size_t c = 0; c < 12; ++c) {
        EXPECT_LT(angle_between(Vec3d(split[c]), c < 6 ? left : right), 1e-6);
    }
    for (const std::size_t c : {1u, 2u, 4u, 6u, 9u, 11u}) {
        EXPECT_LT(angle_between(Vec3d(joined[c]), {0, 0, 1}), 0.6) << c;
        EXPECT_GT(angle_between(Vec3d(joined[c]), c < 6 ? left : right), 0.1) << c;
    }
}

TEST(Normals, FansThatShareOnlyAPointStayApart) {
    Mesh mesh;  // a bow tie, its halves 20 degrees apart: below the crease, yet not neighbours
    const double h = std::tan(20 * std::numbers::pi / 180);
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, h}, {-1, -1, h}};
    mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
    add_whole_part(mesh);
    const auto normals = corner_normals(mesh, 40.0);
    EXPECT_LT(angle_between(Vec3d(normals[0]), flat_normal(mesh, 0)), 1e-6);
    EXPECT_LT(angle_between(Vec3d(normals[3]), flat_normal(mesh, 1)), 1e-6);
}

TEST(Normals, DegenerateFacesAreLookedThrough) {
    // A gently bent strip whose shared edge carries a zero-area triangle.
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 2, 0}, {0, 1, 0}, {-1, 0, -0.1}, {1, 0, -0.1}};
    mesh.triangles = {{0, 1, 3}, {0, 1, 2}, {0, 4, 2}, {2, 4, 1}, {3, 3, 3}};
    add_whole_part(mesh);
    const auto normals = corner_normals(mesh, 40.0);
    expect_unit(normals);
    // At point 0 the left face has the angle, and so the weight, of the right one.
    EXPECT_LT(angle_between(Vec3d(normals[0]), {0, 0, 1}), 1e-6);
    EXPECT_EQ(normals[0], normals[6]) << "smooth across the sliver";
    EXPECT_EQ(normals[3], normals[0]) << "the sliver takes over its neighbours' normal";
    EXPECT_EQ(normals[12], normals[2]) << "a face that is one point takes that point's";
}

TEST(Normals, NothingButDegenerateFacesPointsUp) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    mesh.triangles = {{0, 1, 2}};
    add_whole_part(mesh);
    for (const Vec3f& n : corner_normals(mesh, 40.0)) EXPECT_EQ(n, Vec3f(0, 0, 1));
}

TEST(Normals, SizesFarFromOneChangeNothing) {
    const auto expected = corner_normals(sphere_mesh(6, 8), 40.0);
    for (const double scale : {0x1p-600, 0x1p-30, 0x1p30, 0x1p600}) {
        Mesh mesh = sphere_mesh(6, 8);
        for (Vec3d& p : mesh.positions) p *= scale;
        EXPECT_EQ(corner_normals(mesh, 40.0), expected) << scale;
    }
}

TEST(Normals, GivenOnesAreKeptAndBadOnesReplaced) {
    Mesh mesh = cube_mesh();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    mesh.corners.normals.assign(36, Vec3f(3.0f, 0.0f, 4.0f));
    mesh.corners.normals[5] = Vec3f(0.0f);
    mesh.corners.normals[6] = Vec3f(nan, 0.0f, 1.0f);
    mesh.corners.normals[7] = Vec3f(infinity, 0.0f, 0.0f);
    mesh.corners.normals[8] = Vec3f(1e-30f, 0.0f, 0.0f);
    const auto normals = corner_normals(mesh, 40.0);
    EXPECT_LT(glm::length(normals[0] - Vec3f(0.6f, 0.0f, 0.8f)), 1e-6f);
    for (const std::size_t c : {5u, 6u, 7u}) {
        EXPECT_LT(glm::length(Vec3d(normals[c]) - flat_normal(mesh, c / 3)), 1e-6) << c;
    }
    EXPECT_EQ(normals[8], Vec3f(1, 0, 0)) << "short is not zero";
}

TEST(Normals, AHubOfManyFacesIsNoTrouble) {
    Mesh mesh;  // 20,000 faces on one edge: quadratic work would show
    mesh.positions = {{0, 0, 0}, {0, 0, 1}};
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const double turn = 2 * std::numbers::pi * i / 20000;
        mesh.positions.push_back({std::cos(turn), std::sin(turn), 0});
        mesh.triangles.push_back({0, 1, i + 2});
    }
    add_whole_part(mesh);
    expect_unit(corner_normals(mesh, 40.0));
}

}  // namespace
}  // namespace burl
