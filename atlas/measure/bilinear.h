#pragma once
// Bilinear lookup as graphics hardware defines it, in double, clamped to the image's edge.
#include <algorithm>
#include <array>
#include <cmath>

#include "atlas/base/image.h"
#include "atlas/base/vec.h"

namespace burl {

/// The four texels of a lookup and their weights, which add to 1.
struct BilinearTaps {
    std::array<std::size_t, 2> x{}, y{};
    std::array<double, 2> weight_x{}, weight_y{};
};

/// The taps of a lookup at `at`, in texels of an image of that size; texel (i,j) has its centre at
/// (i+0.5, j+0.5).
inline BilinearTaps bilinear_taps(const Vec2d& at, std::size_t width, std::size_t height) {
    BilinearTaps taps;
    const auto axis = [](double coordinate, std::size_t size, auto& index, auto& weight) {
        const double last = double(size) - 1.0;
        const double c = std::clamp(coordinate - 0.5, 0.0, last);
        const double low = std::floor(c);
        index = {std::size_t(low), std::size_t(std::min(low + 1.0, last))};
        weight = {1.0 - (c - low), c - low};
    };
    axis(at.x, width, taps.x, taps.weight_x);
    axis(at.y, height, taps.y, taps.weight_y);
    return taps;
}

/// The bilinearly filtered value at `at`, in texels of the image.
inline Vec3d bilinear(const Image<Vec3f>& image, const Vec2d& at) {
    const BilinearTaps t = bilinear_taps(at, image.width(), image.height());
    Vec3d sum(0.0);
    for (std::size_t j : {0u, 1u})
        for (std::size_t i : {0u, 1u})
            sum += t.weight_x[i] * t.weight_y[j] * Vec3d(image(t.x[i], t.y[j]));
    return sum;
}

}  // namespace burl
