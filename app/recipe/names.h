#pragma once
// The recipes' words for enumerations of the procedural texture, which knows no recipes.
#include <string_view>

#include "atlas/base/enum_names.h"
#include "procedural/batch/filter.h"
#include "procedural/batch/precision.h"
#include "procedural/model/texture.h"
#include "procedural/noise/names.h"

namespace burl {

/// The words of a table that has all enumerators in the order of their values.
template <class Enum, std::size_t N>
constexpr std::array<std::string_view, N> words_of(const std::array<Named<Enum>, N>& table) {
    std::array<std::string_view, N> words;
    for (std::size_t k = 0; k < N; ++k) words[std::size_t(table[k].value)] = table[k].name;
    return words;
}

template <>
inline constexpr auto enum_names<NoiseKind> = words_of(noise_kinds);
template <>
inline constexpr auto enum_names<Fade> = words_of(fade_names);
template <>
inline constexpr auto enum_names<WorleyFeature> = words_of(feature_names);
template <>
inline constexpr auto enum_names<OctaveShape> = words_of(sum_names);
template <>
inline constexpr auto enum_names<NoiseRange> = enum_words("unit", "signed");
template <>
inline constexpr auto enum_names<Wrap> = enum_words("repeat", "clamp");
template <>
inline constexpr auto enum_names<FilterKind> = enum_words("none", "table-mip", "table-sat",
                                                          "table-sat3", "exact", "trapezoid",
                                                          "trapezoid2", "supersample");
template <>
inline constexpr auto enum_names<PrecisionKind> = enum_words("float32", "float64", "fixed");

}  // namespace burl
