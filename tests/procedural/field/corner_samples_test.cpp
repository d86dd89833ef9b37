// Means and slopes from corners against the closed forms of a quadratic field, and against noise
// averaged in float64.
#include "procedural/field/corner_samples.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

namespace burl {
namespace {

/// Pieces of all lengths, more texels together than one batch of corners holds.
std::unique_ptr<FieldBatch> some_texels(double step) {
    auto batch = std::make_unique<FieldBatch>();
    const std::size_t counts[] = {1, 2, 300, 1, 1, 1, 17, 600, 101};
    std::size_t y = 0;
    for (const std::size_t count : counts) {
        const double k = double(y);
        batch->pieces.push_back(
            {3 * y,
             y,
             {Vec3d(0.3 * k, -0.1 * k, 0.2), step * Vec3d(0.5, 1.0, -0.3 * k), 10.0 * k, count},
             step * Vec3d(-0.7, 0.4, 0.9)});
        batch->count += count;
        ++y;
    }
    EXPECT_EQ(batch->count, batch_capacity);
    return batch;
}

/// visit(texel of the batch, piece, its centre).
template <class Visit>
void for_each_texel(const FieldBatch& batch, const Visit& visit) {
    std::size_t at = 0;
    for (const Piece& piece : batch.pieces)
        for (std::size_t j = 0; j < piece.solid.count; ++j, ++at)
            visit(at, piece,
                  piece.solid.start + (piece.solid.first + double(j)) * piece.solid.step);
}

TEST(CornerSamples, AreExactForAQuadric) {
    Texture texture;
    texture.quadric = {0.7, -0.2, 0.3, 0.1, -0.5, 0.4, 0.9, 1.1, -0.6, 0.25};
    const Quadric& q = texture.quadric;
    const FieldSampler sampler(texture, false);
    const auto batch = some_texels(0.02);
    CornerBuffers buffers;
    sampler.values(*batch);
    average_with_corners(sampler, *batch, buffers);
    for_each_texel(*batch, [&](std::size_t at, const Piece& piece, const Vec3d& p) {
        const Vec3d gradient = 2.0 * half_gradient(q, p);
        // The second derivative along d is twice the quadratic form of d.
        const auto bend = [&](const Vec3d& d) {
            return 2.0 * glm::dot(d, half_gradient(q, d) - half_gradient(q, Vec3d(0.0)));
        };
        const double mean =
            evaluate_quadric(q, p) + (bend(piece.solid.step) + bend(piece.down)) / 24.0;
        EXPECT_NEAR(batch->field[at], mean, 1e-11);
        EXPECT_NEAR(batch->slopes.u[at], glm::dot(gradient, piece.solid.step), 1e-6);
        EXPECT_NEAR(batch->slopes.v[at], glm::dot(gradient, piece.down), 1e-6);
    });
}

TEST(CornerSamples, ComeCloserToTheMeanOfNoiseThanTheCentre) {
    Texture texture;
    texture.noise.emplace_back();
    texture.noise[0].kind = NoiseKind::perlin;
    texture.noise[0].frequency = Vec3d(4.0);
    const std::vector<Octave> octaves = expand_octaves(texture);
    const FieldSampler sampler(texture, false);
    const auto batch = some_texels(0.05);
    CornerBuffers buffers;
    sampler.values(*batch);
    const std::vector<double> centres(batch->field, batch->field + batch->count);
    average_with_corners(sampler, *batch, buffers);
    double error = 0.0, error_of_centres = 0.0;
    for_each_texel(*batch, [&](std::size_t at, const Piece& piece, const Vec3d& p) {
        double mean = 0.0;
        constexpr int n = 6;
        for (int i = 0; i < n * n; ++i)
            mean += evaluate_field({}, octaves,
                                   p + ((i % n + 0.5) / n - 0.5) * piece.solid.step +
                                       ((i / n + 0.5) / n - 0.5) * piece.down) /
                    (n * n);
        error += std::pow(batch->field[at] - mean, 2);
        error_of_centres += std::pow(centres[at] - mean, 2);
    });
    EXPECT_LT(std::sqrt(error / error_of_centres), 0.15);
}

}  // namespace
}  // namespace burl
