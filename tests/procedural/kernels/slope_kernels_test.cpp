// Gradients on streams against those of the float64 noise, values against the kernels of values, to
// the bit, and slopes along texels' sides against float64.
#include "procedural/kernels/slope_kernels.h"

#include <memory>

#include <gtest/gtest.h>

#include "procedural/kernels/share_kernels.h"
#include "procedural/noise/noise.h"
#include "tests/procedural/support/random_batch.h"

namespace burl {
namespace {

using test::for_each_texel;
using test::NoiseName;
using test::random_batch;
constexpr auto& slope_kernels_noises = test::shared_noises;

struct Sums {
    alignas(64) float values[batch_capacity + batch_padding] = {};
    GradientSums gradients = {};
};

/// A stream, and the points that its numbers stand for.
struct Stream {
    LatticeStream lattice;
    std::vector<Piece> pieces;
    std::vector<Vec3d> points;

    Stream(std::mt19937& random, double reach, double side)
        : pieces(random_batch(random, reach, side)) {
        fill_stream({}, 0, pieces, lattice);
        for (std::size_t j = 0; j < batch_capacity; ++j) {
            Vec3d& p = points.emplace_back();
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = double(std::int64_t(lattice.at(axis, j))) * 0x1p-32;
        }
    }
};

Vec3d gradient(const NoiseName& k, std::uint32_t seed, const Vec3d& p) {
    const NoiseSpec noise{.kind = k.kind, .fade = k.fade, .seed = seed};
    const auto sample = sample_noise<double, 3>(noise, {p.x, p.y, p.z});
    return {sample.gradient[0], sample.gradient[1], sample.gradient[2]};
}

TEST(SlopeKernels, GradientsAreTheReferences) {
    std::mt19937 random(11);
    for (const NoiseName& k : slope_kernels_noises)
        for (const int doublings : {0, 1, 6}) {
            const auto stream = std::make_unique<Stream>(random, 50.0, 0.4);
            const StreamOctave octave{std::uint32_t(random()), doublings, 0.75f};
            const double factor = std::ldexp(1.0, doublings);
            const auto sums = std::make_unique<Sums>();
            gradient_kernel(k.kind, k.fade)(octave, stream->lattice, nullptr, batch_capacity,
                                            sums->values, &sums->gradients);
            for (std::size_t j = 0; j < batch_capacity; ++j) {
                const Vec3d exact = gradient(k, octave.seed, factor * stream->points[j]);
                for (int axis = 0; axis < 3; ++axis)
                    ASSERT_NEAR(double(sums->gradients.along[axis][j]) * stream_unit(k.kind) /
                                    (0.75 * factor),
                                exact[axis], 1e-6)
                        << int(k.kind) << int(k.fade) << doublings;
            }
        }
}

TEST(SlopeKernels, AddToWhatIsThereWithTheBitsOfTheOtherKernels) {
    std::mt19937 random(12);
    for (const NoiseName& k : slope_kernels_noises)
        for (int i = 0; i < 12; ++i) {
            const auto stream = std::make_unique<Stream>(random, 1e6, std::ldexp(1.0, -i));
            const auto runs = std::make_unique<CellRuns>();
            const std::size_t count = i < 6 ? batch_capacity : 1 + random() % batch_capacity;
            const StreamOctave octave{std::uint32_t(random()), i % 4, -0.6f};
            const auto values = std::make_unique<Sums>(), direct = std::make_unique<Sums>(),
                       shared = std::make_unique<Sums>();
            find_runs(stream->lattice, i % 4 + i % 2, count, *runs);
            for (int times = 0; times < 2; ++times) {
                direct_kernel(k.kind, k.fade)(octave, stream->lattice, nullptr, count,
                                              values->values, nullptr);
                gradient_kernel(k.kind, k.fade)(octave, stream->lattice, nullptr, count,
                                                direct->values, &direct->gradients);
                sharing_kernel(k.kind, k.fade, true)(octave, stream->lattice, runs.get(), count,
                                                     shared->values, &shared->gradients);
            }
            for (std::size_t j = 0; j < count; ++j) {
                ASSERT_EQ(direct->values[j], values->values[j]) << i;
                ASSERT_EQ(shared->values[j], values->values[j]) << i;
                for (int axis = 0; axis < 3; ++axis)
                    ASSERT_EQ(direct->gradients.along[axis][j], shared->gradients.along[axis][j]);
            }
            const auto once = std::make_unique<Sums>();
            gradient_kernel(k.kind, k.fade)(octave, stream->lattice, nullptr, count, once->values,
                                            &once->gradients);
            for (std::size_t j = 0; j < count; ++j)
                ASSERT_EQ(direct->gradients.along[2][j], 2.0f * once->gradients.along[2][j]);
        }
}

const Affine3 slope_kernels_oblique{Mat3d(1.5, 0.25, 0, -0.75, 2, 0.5, 0, 0.125, 1),
                                    Vec3d(0.3, -7.0, 100.0)};

TEST(SlopeKernels, LookAtGradientsAlongTheSides) {
    std::mt19937 random(13);
    std::vector<Piece> pieces = random_batch(random, 10.0, 0.5);
    pieces[3].down = {1e300, 0.01, 0.02};       // out of the lattice along the first axis ...
    pieces[5].solid.step = {1e16, 1e16, 1e16};  // ... and along all of them
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    const auto gradients = std::make_unique<GradientSums>();
    for (auto& along : gradients->along)
        for (float& g : along) g = unit(random);
    const auto slopes = std::make_unique<SlopeBatch>();
    std::fill_n(slopes->u, batch_capacity, 0.5f);
    std::fill_n(slopes->v, batch_capacity, -0.25f);
    add_slopes(slope_kernels_oblique, -1.25, pieces, *gradients, *slopes);
    for_each_texel(pieces, [&](std::size_t at, const Piece& piece, const Vec3d&) {
        const auto slope = [&](const Vec3d& side) {
            const Vec3d mapped = slope_kernels_oblique.linear * side;
            double sum = 0.0;
            for (int axis = 0; axis < 3; ++axis)
                if (std::abs(mapped[axis]) < 0x1p50)
                    sum += double(gradients->along[axis][at]) * mapped[axis];
            return -1.25 * sum;
        };
        ASSERT_NEAR(slopes->u[at], 0.5 + slope(piece.solid.step), 1e-6) << at;
        ASSERT_NEAR(slopes->v[at], -0.25 + slope(piece.down), 1e-6) << at;
    });
}

TEST(SlopeKernels, QuadricsHaveTheirGradients) {
    const Quadric q{1.5, -2, 0.25, 3, -0.75, 1, 2, 0.5, -1, 7};
    std::mt19937 random(14);
    const std::vector<Piece> pieces = random_batch(random, 3.0, 0.1);
    const auto slopes = std::make_unique<SlopeBatch>();
    fill_quadric_slopes(q, pieces, *slopes);
    for_each_texel(pieces, [&](std::size_t at, const Piece& piece, const Vec3d& p) {
        const Vec3d gradient = 2.0 * half_gradient(q, p);
        ASSERT_NEAR(slopes->u[at], glm::dot(gradient, piece.solid.step), 3e-7) << at;
        ASSERT_NEAR(slopes->v[at], glm::dot(gradient, piece.down), 3e-7) << at;
    });
}

}  // namespace
}  // namespace burl
