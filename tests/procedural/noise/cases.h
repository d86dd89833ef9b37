#pragma once
// All noises that exist in N dimensions, by name, and random points at which to evaluate them.
#include <random>
#include <string>
#include <vector>

#include "procedural/noise/noise.h"

namespace burl::test {

struct NoiseCase {
    std::string name;
    NoiseSpec noise;
};

/// Returns the noises that are defined in that number of dimensions.
inline std::vector<NoiseCase> noise_cases(std::size_t dimensions) {
    std::vector<NoiseCase> all{
        {"value linear", {.kind = NoiseKind::value, .fade = Fade::linear}},
        {"value smooth", {.kind = NoiseKind::value, .fade = Fade::smooth}},
        {"value quintic", {.kind = NoiseKind::value, .fade = Fade::quintic}},
        {"perlin", {.kind = NoiseKind::perlin}},
        {"perlin2002", {.kind = NoiseKind::perlin2002}},
        {"perlin1985", {.kind = NoiseKind::perlin1985}},
        {"simplex", {.kind = NoiseKind::simplex}},
        {"simplex .5", {.kind = NoiseKind::simplex, .radius2 = 0.5}},
        {"worley f1", {.kind = NoiseKind::worley, .feature = WorleyFeature::f1}},
        {"worley f2", {.kind = NoiseKind::worley, .feature = WorleyFeature::f2}},
        {"worley f2-f1", {.kind = NoiseKind::worley, .feature = WorleyFeature::f2_f1}},
        {"cell", {.kind = NoiseKind::cell}},
        {"white", {.kind = NoiseKind::white}}};
    std::vector<NoiseCase> defined;
    for (const NoiseCase& one : all)
        if (has_dimensions(one.noise.kind, dimensions)) defined.push_back(one);
    return defined;
}

/// Whether the noise's value is continuous: interpolated noises and simplex noise with a small
/// radius.
inline bool is_continuous(const NoiseCase& one, std::size_t dimensions) {
    const NoiseKind kind = one.noise.kind;
    if (kind == NoiseKind::cell || kind == NoiseKind::white) return false;
    return kind != NoiseKind::simplex || dimensions != 3 || one.noise.radius2 <= 0.5;
}

template <std::size_t N>
Point<N> random_point(std::mt19937& random, double reach) {
    std::uniform_real_distribution<double> coordinate(-reach, reach);
    Point<N> p;
    for (double& x : p) x = coordinate(random);
    return p;
}

/// Calls function(integral_constant) for 1, 2, 3 and 4 dimensions.
template <class Function>
void for_each_dimension(Function&& function) {
    function(std::integral_constant<std::size_t, 1>());
    function(std::integral_constant<std::size_t, 2>());
    function(std::integral_constant<std::size_t, 3>());
    function(std::integral_constant<std::size_t, 4>());
}

}  // namespace burl::test
