#pragma once
// The words for noises in recipes, on the command line and in `burl list noises`.
#include <array>
#include <string_view>

#include "atlas/base/enum_names.h"
#include "procedural/noise/fractal_sum.h"
#include "procedural/noise/spec.h"

namespace burl {

/// A value with its name and, for `burl list`, a line of explanation.
template <class T>
struct Named {
    std::string_view name;
    T value;
    std::string_view text = "";
};
/// Compilers before C++20's deduction for aggregates (clang 14) need it said.
template <class T>
Named(std::string_view, T, std::string_view = "") -> Named<T>;

/// The words of a table that has all enumerators in the order of their values.
template <class Enum, std::size_t N>
constexpr std::array<std::string_view, N> words_of(const std::array<Named<Enum>, N>& table) {
    std::array<std::string_view, N> words;
    for (std::size_t k = 0; k < N; ++k) words[std::size_t(table[k].value)] = table[k].name;
    return words;
}

inline constexpr std::array noise_kinds{
    Named{"value", NoiseKind::value, "interpolated lattice values; fade linear, smooth or quintic"},
    Named{"perlin", NoiseKind::perlin, "improved Perlin gradient noise (2002)"},
    Named{"perlin2002", NoiseKind::perlin2002,
          "improved Perlin gradient noise with his published permutation (2002)"},
    Named{"perlin1985", NoiseKind::perlin1985, "Perlin's original gradient noise and tables"},
    Named{"simplex", NoiseKind::simplex, "Perlin's simplex noise with bit-pattern hash (2001)"},
    Named{"worley", NoiseKind::worley,
          "distance to random points; feature f1, f2 or f2-f1 (Worley 1996)"},
    Named{"cell", NoiseKind::cell, "one random number for every lattice cell"},
    Named{"white", NoiseKind::white, "one random number for every point"}};
template <>
inline constexpr auto enum_names<NoiseKind> = words_of(noise_kinds);

inline constexpr std::array fade_names{Named{"linear", Fade::linear}, Named{"smooth", Fade::smooth},
                                       Named{"quintic", Fade::quintic}};
template <>
inline constexpr auto enum_names<Fade> = words_of(fade_names);

inline constexpr std::array feature_names{Named{"f1", WorleyFeature::f1},
                                          Named{"f2", WorleyFeature::f2},
                                          Named{"f2-f1", WorleyFeature::f2_f1}};
template <>
inline constexpr auto enum_names<WorleyFeature> = words_of(feature_names);

inline constexpr std::array sum_names{Named{"fbm", OctaveShape::plain},
                                      Named{"turbulence", OctaveShape::absolute},
                                      Named{"ridged", OctaveShape::ridged}};
template <>
inline constexpr auto enum_names<OctaveShape> = words_of(sum_names);

}  // namespace burl
