// Tangent space: there and back, and as codes.
#include "procedural/fill/tangent_frame.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace burl {
namespace {

class RandomVectors {
  public:
    Vec3d unit() {
        return glm::normalize(Vec3d{gauss_(random_), gauss_(random_), gauss_(random_)});
    }

  private:
    std::mt19937 random_{7};
    std::normal_distribution<double> gauss_;
};

double tangent_frame_degrees_between(const Vec3d& a, const Vec3d& b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

TEST(TangentFrame, FollowsTheFormat) {
    // glTF 3.7.2.1: bitangent = cross(normal, tangent.xyz) * tangent.w.
    const TangentFrame upright = tangent_frame({0, 0, 5}, {3, 0, 0}, 1.0);
    EXPECT_EQ(upright.bitangent, Vec3d(0, 1, 0));
    EXPECT_EQ(tangent_frame({0, 0, 5}, {3, 0, 0}, -1.0).bitangent, Vec3d(0, -1, 0));
    EXPECT_EQ(in_frame(upright, {1, 0, 0}), Vec3d(1, 0, 0));
    EXPECT_EQ(in_frame(upright, {0, 1, 0}), Vec3d(0, 1, 0));
}

TEST(TangentFrame, GivesBackWhatWasPutInEvenWhereItIsSlanted) {
    RandomVectors vectors;
    int tried = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3d normal = vectors.unit();
        const TangentFrame frame = tangent_frame(normal, vectors.unit(), i % 2 == 0 ? 1.0 : -1.0);
        const Vec3d v = vectors.unit();
        const double slant = glm::dot(frame.tangent, frame.normal);
        // A viewer can only show what has a positive share of the normal.
        if (std::abs(slant) > 0.99 || glm::dot(frame.normal - slant * frame.tangent, v) <= 0.0)
            continue;
        const Vec3d c = in_frame(frame, v);
        EXPECT_NEAR(glm::length(c), 1.0, 1e-12);
        EXPECT_LT(glm::length(from_frame(frame, c) - v), 1e-12);
        ++tried;
    }
    EXPECT_GT(tried, 500);
}

TEST(TangentFrame, NormalsThemselvesAreStraightUp) {
    RandomVectors vectors;
    for (int i = 0; i < 100; ++i) {
        const Vec3d normal = vectors.unit();
        const TangentFrame frame = tangent_frame(normal, vectors.unit(), 1.0);
        EXPECT_EQ(in_frame(frame, frame.normal), Vec3d(0, 0, 1));
    }
    const Vec3d n(0, 0, 1);
    EXPECT_EQ(in_frame(tangent_frame(n, n, 1.0), {1, 0, 0}), Vec3d(0, 0, 1)) << "no frame";
    EXPECT_EQ(in_frame(tangent_frame(n, {1, 0, 0}, 1.0), {0, 0, -1}), Vec3d(0, 0, 1));
}

/// The direction that viewers read: 2 code / largest - 1 for every component, made unit length.
template <class Code>
Vec3d decode_normal(const Rgb<Code>& codes) {
    const double largest = double(std::numeric_limits<Code>::max());
    return glm::normalize(2.0 / largest * Vec3d(codes.r, codes.g, codes.b) - 1.0);
}

TEST(NormalCodes, FlatIsTheKnownBlue) {
    EXPECT_EQ(encode_normal<std::uint8_t>({0, 0, 1}), (Rgb8{128, 128, 255}));
    EXPECT_EQ(encode_normal<std::uint16_t>({0, 0, 1}), (Rgb16{32768, 32768, 65535}));
    EXPECT_EQ(encode_normal<std::uint8_t>({-1, 1, 0}), (Rgb8{0, 255, 128}));
    EXPECT_EQ(encode_normal<std::uint8_t>({-1.5, 1.5, 0}), (Rgb8{0, 255, 128}));
}

TEST(NormalCodes, ComeBackWithinHalfACode) {
    RandomVectors vectors;
    double worst8 = 0.0, worst16 = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3d n = vectors.unit();
        worst8 = std::max(worst8, tangent_frame_degrees_between(
                                      n, decode_normal(encode_normal<std::uint8_t>(n))));
        worst16 = std::max(worst16, tangent_frame_degrees_between(
                                        n, decode_normal(encode_normal<std::uint16_t>(n))));
    }
    // Half a code in each of three axes: sqrt(3) / 255 radians at most.
    EXPECT_LT(worst8, glm::degrees(std::sqrt(3.0) / 255.0));
    EXPECT_GT(worst8, 0.2);
    EXPECT_LT(worst16, glm::degrees(std::sqrt(3.0) / 65535.0));
    const Vec3d flat = decode_normal(Rgb8{128, 128, 255});
    EXPECT_NEAR(tangent_frame_degrees_between(flat, {0, 0, 1}), 0.318, 0.001)
        << "128 is not quite 0";
}

}  // namespace
}  // namespace burl
