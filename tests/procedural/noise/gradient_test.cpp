// Gradients against central differences of the values, and continuity, for every noise.
#include <algorithm>

#include <gtest/gtest.h>

#include "procedural/noise/domain_warp.h"
#include "procedural/noise/fractal_sum.h"
#include "tests/procedural/noise/cases.h"

namespace burl {
namespace {

using test::NoiseCase;

/// Central differences of fourth order of `value` about p.
template <std::size_t N, class Value>
std::array<double, N> differences(const Point<N>& p, double h, Value&& value) {
    std::array<double, N> result;
    for (std::size_t axis = 0; axis < N; ++axis) {
        const auto at = [&](double step) {
            Point<N> q = p;
            q[axis] += step;
            return value(q);
        };
        result[axis] = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
    }
    return result;
}

/// Share of `count` random points whose gradient is not what differences say, to 1e-5 relative.
template <std::size_t N, class Sample>
double share_wrong(int count, Sample&& sample) {
    std::mt19937 random(5);
    int wrong = 0;
    for (int i = 0; i < count; ++i) {
        const Point<N> p = test::random_point<N>(random, 40.0);
        const NoiseSample<double, N> n = sample(p);
        const auto expected =
            differences<N>(p, 1e-4, [&](const Point<N>& q) { return sample(q).value; });
        double size = 1.0, error = 0.0;
        for (std::size_t axis = 0; axis < N; ++axis) {
            size = std::max(size, std::abs(expected[axis]));
            error = std::max(error, std::abs(expected[axis] - n.gradient[axis]));
        }
        wrong += error > 1e-5 * size;
    }
    return double(wrong) / count;
}

TEST(NoiseGradient, IsThatOfTheValue) {
    test::for_each_dimension([]<std::size_t N>(std::integral_constant<std::size_t, N>) {
        for (const NoiseCase& one : test::noise_cases(N)) {
            if (one.noise.kind == NoiseKind::white) continue;  // no two points are alike
            // Differences fail across a jump (cells), a kink (Worley's bisectors, linear fades) or
            // a step of the curvature (the s-curve): at a share of the points that is the stencil's
            // 4e-4 times the borders' area per volume.
            const NoiseKind kind = one.noise.kind;
            const bool is_smooth = kind == NoiseKind::perlin || kind == NoiseKind::perlin2002 ||
                                   (kind == NoiseKind::value && one.noise.fade == Fade::quintic) ||
                                   (kind == NoiseKind::simplex && is_continuous(one, N));
            const double allowed = is_smooth ? 0.0 : 0.02;
            const double share = share_wrong<N>(
                1000, [&](const Point<N>& p) { return sample_noise<double>(one.noise, p); });
            EXPECT_LE(share, allowed) << one.name << " " << N;
        }
    });
}

TEST(NoiseGradient, OfSumsAndWarpsFollowsTheChainRule) {
    const auto octave = [](std::uint32_t k, const Point<3>& p) {
        return sample_noise<double>({.kind = NoiseKind::perlin, .seed = k}, p);
    };
    for (const OctaveShape shape :
         {OctaveShape::plain, OctaveShape::absolute, OctaveShape::ridged}) {
        const FractalSum fractal{shape, 4, 1.7, 0.6, true};
        const double share = share_wrong<3>(
            1000, [&](const Point<3>& p) { return fractal_sum<double>(fractal, p, octave); });
        EXPECT_LE(share, shape == OctaveShape::plain ? 0.0 : 0.02) << int(shape);
    }
    const auto warp = [](std::size_t axis, const Point<4>& p) {
        return sample_noise<double>({.kind = NoiseKind::value, .seed = std::uint32_t(axis)}, p);
    };
    const auto inner = [](const Point<4>& p) {
        return sample_noise<double>({.kind = NoiseKind::simplex, .seed = 7}, p);
    };
    EXPECT_EQ(
        share_wrong<4>(1000,
                       [&](const Point<4>& p) { return domain_warp<double>(p, 1.5, warp, inner); }),
        0.0);
}

TEST(NoiseGradient, DomainWarpMovesThePoint) {
    // A warp by constants is a translation; one by 0 is none.
    const NoiseSpec noise{.kind = NoiseKind::perlin};
    const auto inner = [&](const Point<3>& p) { return sample_noise<double>(noise, p); };
    const auto constant = [](std::size_t axis, const Point<3>&) {
        return NoiseSample<double, 3>{double(axis) + 1.0, {}};
    };
    const Point<3> p{0.25, 0.375, -0.125};
    const auto warped = domain_warp<double>(p, 0.5, constant, inner);
    const auto moved = inner({0.75, 1.375, 1.375});
    EXPECT_EQ(warped.value, moved.value);
    EXPECT_EQ(warped.gradient, moved.gradient);
    EXPECT_EQ(domain_warp<double>(p, 0.0, constant, inner).value, inner(p).value);
}

TEST(NoiseContinuity, HoldsAcrossCellFacesAndDiagonals) {
    test::for_each_dimension([]<std::size_t N>(std::integral_constant<std::size_t, N>) {
        std::mt19937 random(6);
        const double h = 1e-9;
        for (const NoiseCase& one : test::noise_cases(N)) {
            if (!is_continuous(one, N)) continue;
            for (int i = 0; i < 500; ++i) {
                Point<N> p = test::random_point<N>(random, 50.0);
                const std::size_t axis = random() % N;
                // On a face, or where two coordinates have equal fractions (borders of simplices).
                if (i % 2 || N == 1)
                    p[axis] = std::round(p[axis]);
                else
                    p[axis] = p[(axis + 1) % N] + std::round(p[axis] - p[(axis + 1) % N]);
                Point<N> below = p, above = p;
                below[axis] -= h, above[axis] += h;
                const double n = sample_noise<double>(one.noise, p).value;
                EXPECT_NEAR(sample_noise<double>(one.noise, below).value, n, 8.0 * h) << one.name;
                EXPECT_NEAR(sample_noise<double>(one.noise, above).value, n, 8.0 * h) << one.name;
            }
        }
    });
}

TEST(NoiseContinuity, GradientsOfSmoothFadesAreContinuousToo) {
    std::mt19937 random(7);
    const double h = 1e-9;
    for (const NoiseCase& one : test::noise_cases(3)) {
        if (!is_continuous(one, 3) || one.noise.kind == NoiseKind::worley ||
            one.noise.fade == Fade::linear)
            continue;
        for (int i = 0; i < 300; ++i) {
            Point<3> p = test::random_point<3>(random, 50.0);
            p[std::size_t(i) % 3] = std::round(p[std::size_t(i) % 3]);
            Point<3> below = p;
            below[std::size_t(i) % 3] -= h;
            const auto a = sample_noise<double>(one.noise, p),
                       b = sample_noise<double>(one.noise, below);
            for (std::size_t axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(a.gradient[axis], b.gradient[axis], 100.0 * h) << one.name;
        }
    }
}

}  // namespace
}  // namespace burl
