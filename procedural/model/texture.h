#pragma once
// The 1999 texture model (Hart, Carr, Kameya, Tibbitts & Coleman, "Antialiased Parameterized Solid
// Texturing"): p(s) = c(f(s)), f(s) = q(s) + sum_i a_i n_i(T_i s). A Texture is a plain comparable
// value.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "atlas/base/enum_names.h"
#include "atlas/base/vec.h"
#include "procedural/color/map.h"
#include "procedural/noise/fractal_sum.h"
#include "procedural/noise/spec.h"

namespace burl {

/// q(s,t,r) = A s^2 + 2B st + 2C sr + 2D s + E t^2 + 2F tr + 2G t + H r^2 + 2I r + J, eq. (3).
struct Quadric {
    double a = 0, b = 0, c = 0, d = 0, e = 0, f = 0, g = 0, h = 0, i = 0, j = 0;
    bool operator==(const Quadric&) const = default;
};

enum class NoiseRange { unit, bipolar };  ///< [0, 1] or [-1, 1]
template <>
inline constexpr auto enum_names<NoiseRange> = enum_words("unit", "signed");

/// A noise term: octave k adds amplitude * gain^k * n_{seed+k}(lacunarity^k F s + phase), k =
/// 0..octaves-1, where F is diag(frequency). `matrix` (row-major 3x4) replaces frequency and phase:
/// F is its 3x3 part, phase its last column. With a `shape`, n is replaced by |n| or (1 - |n|)^2.
struct NoiseTerm {
    NoiseKind kind = NoiseKind::value;
    Fade fade = Fade::smooth;  ///< fade of value noise
    WorleyFeature feature = WorleyFeature::f1;
    double radius2 = 0.6;  ///< squared radius of simplex noise's kernels
    /// Periods in cells of the first octave, 0 for none; with one, lacunarity must be whole and
    /// has_period hold.
    Period<3> period{};
    std::optional<double> time;     ///< fourth lattice coordinate, the same in every octave
    std::uint32_t time_period = 0;  ///< period in cells along time, 0 for none
    OctaveShape shape = OctaveShape::plain;
    bool normalized = false;  ///< divides amplitudes by sum_k |gain|^k
    /// The range that the noise is taken to. Default: unit for noise that is not negative by itself
    /// and for value noise, signed for the others. Noise n that is not negative is n for `unit` and
    /// 2 n - 1 for `signed`.
    std::optional<NoiseRange> range;
    double amplitude = 1.0;
    Vec3d frequency{1.0};
    Vec3d phase{0.0};
    std::optional<std::array<double, 12>> matrix;
    std::uint32_t seed = 0;
    std::uint32_t octaves = 1;  ///< 1 to 24
    double lacunarity = 2.0;
    double gain = 0.5;
    bool operator==(const NoiseTerm&) const = default;
};

/// p(s) = c(f(s)) with f = quadric + noise, and c = colors.
struct Texture {
    Quadric quadric;
    std::vector<NoiseTerm> noise;
    ColorMap colors;
    bool operator==(const Texture&) const = default;
};

/// f(s) in float64: the reference that every faster path is compared with. `s` is the recipe's
/// solid coordinate (after space and scale).
double evaluate_field(const Texture& texture, const Vec3d& s);

}  // namespace burl
