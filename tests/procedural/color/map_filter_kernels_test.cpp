// The vectorised filters against the ones that go piece by piece, which have tests of their own.
#include "procedural/field/stream_filter.h"

#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include <gtest/gtest.h>

namespace burl {
namespace {

ColorMap jumping_map(Wrap wrap) {
    return {wrap,
            {{0.0, {255, 0, 30}},
             {0.35, {20, 200, 90}},
             {0.35, {0, 10, 250}},
             {0.36, {240, 240, 10}},
             {1.0, {5, 90, 140}}}};
}

std::vector<ColorMap> kernel_maps() {
    return {jumping_map(Wrap::repeat),
            jumping_map(Wrap::clamp),
            {Wrap::repeat, {{0.0, {10, 20, 30}}, {0.5, {250, 200, 100}}}},
            {Wrap::repeat, {{0.3, {7, 77, 177}}}},
            {Wrap::clamp, {{0.2, {0, 0, 0}}, {0.9, {255, 255, 255}}}},
            {Wrap::clamp, {{0.5, {9, 9, 9}}, {0.5, {200, 200, 200}}}}};
}

/// A batch of texels with footprints of all sizes, and what a filter makes of it.
struct Case {
    std::vector<double> f;
    std::unique_ptr<SlopeBatch> slopes = std::make_unique<SlopeBatch>();
    std::unique_ptr<FilterBuffers> buffers = std::make_unique<FilterBuffers>();

    explicit Case(std::size_t count, double reach, double least, double most) {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        const auto width = [&] {
            return float((unit(random) < 0.5 ? -1.0 : 1.0) *
                         std::exp2(least + (most - least) * unit(random)));
        };
        for (std::size_t i = 0; i < count; ++i) {
            f.push_back(reach * (2.0 * unit(random) - 1.0));
            slopes->u[i] = width();
            slopes->v[i] = width();
        }
        f.resize(count + batch_padding);
    }

    std::size_t count() const { return f.size() - batch_padding; }

    /// visit(texel, mean).
    template <class Visit>
    void filter(const MapPieces& map, bool both_axes, const Visit& visit) {
        StreamFilter(map, both_axes)(
            f.data(), *slopes, count(), *buffers,
            [&](const std::vector<std::uint16_t>& texels, const FootprintStream& stream) {
                for (std::size_t i = 0; i < texels.size(); ++i)
                    visit(texels[i],
                          Vec3d(stream.color[0][i], stream.color[1][i], stream.color[2][i]));
            });
    }
};

double distance(const Vec3d& a, const Vec3d& b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

/// Largest difference from the piecewise filter over the texels that were filtered.
double worst(const ColorMap& map, bool both_axes, Case& texels, std::size_t& filtered) {
    const MapPieces pieces(map);
    double largest = 0.0;
    texels.filter(pieces, both_axes, [&](std::size_t i, const Vec3d& mean) {
        const auto w = FilterWidths::of(texels.slopes->u[i], texels.slopes->v[i]);
        const Vec3d expected = both_axes ? trapezoid_filtered(pieces, texels.f[i], w)
                                         : box_filtered(pieces, texels.f[i], w.box());
        largest = std::max(largest, distance(mean, expected));
        ++filtered;
    });
    return largest;
}

TEST(StreamFilter, AgreesWithThePiecewiseFilter) {
    // Widths from 2^-20 to 2^4: every kernel has its share.
    Case texels(batch_capacity, 3.0, -20.0, 4.0), narrow(batch_capacity, 1.5, -12.0, -6.0);
    std::size_t filtered = 0;
    for (const ColorMap& map : kernel_maps())
        for (const bool both_axes : {false, true})
            for (Case* one : {&texels, &narrow})
                EXPECT_LT(worst(map, both_axes, *one, filtered), 2e-7);
    EXPECT_GT(filtered, 2000u);
}

TEST(StreamFilter, LeavesOutOnlyTexelsWithoutABreak) {
    Case texels(batch_capacity, 3.0, -9.0, -2.0);
    const MapPieces pieces(jumping_map(Wrap::repeat));
    std::vector<bool> seen(texels.count());
    texels.filter(pieces, true, [&](std::size_t i, const Vec3d&) { seen[i] = true; });
    std::size_t left_out = 0;
    for (std::size_t i = 0; i < texels.count(); ++i) {
        if (seen[i]) continue;
        ++left_out;
        const double f = texels.f[i];
        const auto w = FilterWidths::of(texels.slopes->u[i], texels.slopes->v[i]);
        EXPECT_LT(distance(trapezoid_filtered(pieces, f, w), pieces.extended(f, f)), 1e-12);
    }
    EXPECT_GT(left_out, texels.count() / 10);
}

TEST(StreamFilter, IsAsExactFarOutAndForHugeFootprints) {
    for (const ColorMap& map : kernel_maps()) {
        std::size_t filtered = 0;
        Case far(500, 1e9, -3.0, 3.0), huge(500, 2.0, -3.0, 120.0);
        EXPECT_LT(worst(map, true, far, filtered), 2e-7);
        EXPECT_LT(worst(map, true, huge, filtered), 2e-6);
    }
}

TEST(StreamFilter, WhatIsNotFiniteIsTheColourAtZero) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const ColorMap& map : kernel_maps())
        for (const bool both_axes : {false, true}) {
            Case texels(4, 1.0, -3.0, 0.0);
            texels.f[0] = std::nan("");
            texels.f[1] = -infinity;
            texels.slopes->u[2] = float(infinity);
            texels.slopes->v[3] = float(std::nan(""));
            const MapPieces pieces(map);
            const Vec3d zero = pieces.extended(0.0, 0.0);
            texels.filter(pieces, both_axes, [&](std::size_t i, const Vec3d& mean) {
                if (i < 2) {
                    EXPECT_LT(distance(mean, zero), 1e-9);
                }
                EXPECT_TRUE(std::isfinite(mean.x + mean.y + mean.z));
            });
        }
}

}  // namespace
}  // namespace burl
