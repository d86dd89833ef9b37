#pragma once
// The choice of a noise: a plain comparable value that recipes, the command line and tests share.
// docs/reference/noise.md defines every kind.
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace burl {

enum class NoiseKind { value, perlin, perlin2002, perlin1985, simplex, worley, cell, white };
enum class Fade { linear, smooth, quintic };
enum class WorleyFeature { f1, f2, f2_f1 };

/// Periods per axis in cells; 0 stands for no period.
template <std::size_t N>
using Period = std::array<std::uint32_t, N>;
inline constexpr std::uint32_t largest_period = 1u << 30;

struct NoiseSpec {
    NoiseKind kind = NoiseKind::value;
    Fade fade = Fade::smooth;                   ///< fade of value noise
    WorleyFeature feature = WorleyFeature::f1;  ///< distance that Worley's noise takes
    double radius2 = 0.6;                       ///< squared radius of 3-D simplex kernels, (0, 0.6]
    std::uint32_t seed = 0;
    Period<4> period{};  ///< periods in cells, each at most largest_period; 0 for none
    /// The fourth coordinate of points that have three, for kinds defined in four dimensions.
    std::optional<double> time{};
    bool operator==(const NoiseSpec&) const = default;
};

/// Whether the kind is defined for points of `dimensions` coordinates.
constexpr bool has_dimensions(NoiseKind kind, std::size_t dimensions) {
    switch (kind) {
        case NoiseKind::perlin:
        case NoiseKind::perlin2002:
            return dimensions == 3 || dimensions == 4;
        case NoiseKind::perlin1985:
            return dimensions >= 1 && dimensions <= 3;
        case NoiseKind::simplex:
            return dimensions >= 2 && dimensions <= 4;
        default:
            return dimensions >= 1 && dimensions <= 4;
    }
}

/// Whether the noise can repeat after `period` cells along an axis. Simplices tile a box only in
/// three dimensions, where a whole number of them fits into every third cell.
constexpr bool has_period(NoiseKind kind, std::size_t dimensions, std::uint32_t period) {
    if (period > largest_period) return false;
    return period == 0 || kind != NoiseKind::simplex || (dimensions == 3 && period % 3 == 0);
}

/// Whether the noise interpolates the samples at the corners of a cubic cell.
constexpr bool is_interpolated(NoiseKind kind) {
    return kind == NoiseKind::value || kind == NoiseKind::perlin || kind == NoiseKind::perlin2002 ||
           kind == NoiseKind::perlin1985;
}

/// Whether the noise is a distance, which is never negative; the other kinds have both signs.
constexpr bool is_distance(NoiseKind kind) {
    return kind == NoiseKind::worley;
}

}  // namespace burl
