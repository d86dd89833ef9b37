// Slopes against central differences of the float64 noise, and values against the kernels of
// values, to the bit.
#include "procedural/slope_kernels.h"

#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "procedural/noise.h"

namespace burl {
namespace {

struct Kernel {
    NoiseKind kind;
    Fade fade;
    double bound;  ///< of the slopes, per |direction|_1
};

constexpr Kernel kernels[] = {{NoiseKind::value, Fade::linear, 1.5e-6},
                              {NoiseKind::value, Fade::smooth, 1.5e-6},
                              {NoiseKind::value, Fade::quintic, 1.5e-6},
                              {NoiseKind::perlin, Fade::quintic, 2e-6}};

struct Case {
    LatticeBatch lattice;
    DirectionBatch directions;
    std::vector<Vec3d> points, u, v;
};

std::unique_ptr<Case> random_case(double reach) {
    auto result = std::make_unique<Case>();
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-reach, reach), step(-0.4, 0.4);
    std::vector<LatticeLine> lines;
    for (int i = 0; i < 64; ++i) {
        LatticeLine line{{place(random), place(random), place(random)},
                         {step(random), step(random), step(random)},
                         0.0,
                         13};
        const Vec3d v(step(random), step(random), step(random));
        for (std::size_t j = 0; j < line.count; ++j) {
            for (int axis = 0; axis < 3; ++axis) {
                result->directions.along_u[axis][result->points.size()] = float(line.step[axis]);
                result->directions.along_v[axis][result->points.size()] = float(v[axis]);
            }
            result->points.push_back(line.start + double(j) * line.step);
            result->u.push_back(line.step);
            result->v.push_back(v);
        }
        lines.push_back(line);
    }
    split_lattice_lines(lines, result->lattice);
    return result;
}

double slope(const Kernel& k, const Vec3d& p, const Vec3d& direction) {
    const double h = 1e-5;
    const NoiseSpec noise{.kind = k.kind, .fade = k.fade, .seed = 7};
    return (evaluate_noise(noise, p + h * direction) - evaluate_noise(noise, p - h * direction)) /
           (2.0 * h);
}

bool near_a_border(const Vec3d& p) {
    const Vec3d off = glm::abs(p - glm::round(p));
    return std::min({off.x, off.y, off.z}) < 1e-4;
}

double sum_of(const Vec3d& d) {
    return std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
}

TEST(SlopeKernels, AgreeWithDifferences) {
    const auto c = random_case(50.0);
    const std::size_t count = c->points.size();
    for (const Kernel& k : kernels) {
        double sums[batch_capacity + batch_padding] = {};
        const auto slopes = std::make_unique<SlopeBatch>();
        add_noise_and_slopes(k.kind, k.fade, 7, 2.0, c->lattice, c->directions, count, sums,
                             *slopes);
        for (std::size_t j = 0; j < count; ++j) {
            if (k.fade == Fade::linear && near_a_border(c->points[j])) continue;
            // 2e-9: the difference's own error.
            EXPECT_NEAR(slopes->u[j] / 2.0, slope(k, c->points[j], c->u[j]),
                        k.bound * sum_of(c->u[j]) + 2e-9);
            EXPECT_NEAR(slopes->v[j] / 2.0, slope(k, c->points[j], c->v[j]),
                        k.bound * sum_of(c->v[j]) + 2e-9);
        }
    }
}

TEST(SlopeKernels, ValuesHaveTheBitsOfTheOtherKernels) {
    const auto c = random_case(1e6);
    const std::size_t count = c->points.size();
    for (const Kernel& k : kernels) {
        std::vector<double> with(batch_capacity + batch_padding, 0.25), without = with;
        const auto slopes = std::make_unique<SlopeBatch>();
        add_noise_and_slopes(k.kind, k.fade, 3, 0.7, c->lattice, c->directions, count, with.data(),
                             *slopes);
        add_noise(k.kind, k.fade, 3, 0.7, c->lattice, count, without.data());
        with.resize(count), without.resize(count);
        EXPECT_EQ(with, without);
    }
}

TEST(SlopeKernels, AddToWhatIsThere) {
    const auto c = random_case(5.0);
    const std::size_t count = c->points.size();
    std::vector<double> sums(batch_capacity + batch_padding);
    const auto once = std::make_unique<SlopeBatch>(), twice = std::make_unique<SlopeBatch>();
    const Kernel& k = kernels[3];
    add_noise_and_slopes(k.kind, k.fade, 3, 1.0, c->lattice, c->directions, count, sums.data(),
                         *once);
    for (int i = 0; i < 2; ++i)
        add_noise_and_slopes(k.kind, k.fade, 3, 1.0, c->lattice, c->directions, count, sums.data(),
                             *twice);
    for (std::size_t j = 0; j < count; ++j) {
        EXPECT_FLOAT_EQ(twice->u[j], 2.0f * once->u[j]);
        EXPECT_FLOAT_EQ(twice->v[j], 2.0f * once->v[j]);
    }
}

}  // namespace
}  // namespace burl
