#pragma once
// Blender's functions behind one door: which function, its settings, and numbers in and out. Graphs
// evaluate their steps by it (procedural/graph/program.h).
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "procedural/numbers/dual.h"

namespace burl {

/// Blender's functions of several numbers; the numbers that each takes, in their order, and gives.
enum class BlenderFunction : std::uint8_t {
    noise,        ///< point, detail, roughness, distortion; settings: whether colour: 3 numbers
    musgrave,     ///< point, detail, dimension, lacunarity, offset, gain; settings: kind: 1
    voronoi,      ///< point, smoothness, exponent, randomness; settings: feature, metric, what: 3
    wave,         ///< point, distortion, detail, its scale, roughness, phase; settings: rings,
                  ///< direction, profile: 1
    magic,        ///< point, distortion; settings: depth: 3
    gradient,     ///< point; settings: kind: 1
    brick,        ///< point, mortar, smooth, bias, width, height; settings: offset, its frequency,
                  ///< squash, its frequency: 2
    checker,      ///< point: 1
    white_noise,  ///< point: 3, of the value 1
    math,         ///< three numbers; settings: operation: 1
    vector_math,  ///< three vectors and a scale; settings: operation: 3
    map_range,    ///< number, two ranges, steps; settings: curve: 1
    mix,          ///< weight, two colours; settings: mode: 3
    correct_hsv,  ///< colour, hue, saturation, value, weight: 3
    to_hsv,       ///< colour: 3
    from_hsv,     ///< hue, saturation, value: 3
    contrast,     ///< colour, bright, contrast: 3
    gamma,        ///< colour, exponent: 3
};

/// The largest number of numbers that a function takes.
inline constexpr std::size_t most_blender_inputs = 10;

/// A function with its settings, whole numbers but for those of `brick`.
struct BlenderCall {
    BlenderFunction function = BlenderFunction::math;
    std::array<double, 4> settings{};
    bool operator==(const BlenderCall&) const = default;
};

/// The results of a call: one to three numbers; those beyond a function's own are 0. Numbers that
/// the function takes and that are not among `inputs` count as 0.
template <class T>
std::array<T, 3> blender_value(const BlenderCall& call, std::span<const T> inputs);

extern template std::array<double, 3> blender_value(const BlenderCall&, std::span<const double>);
extern template std::array<Dual, 3> blender_value(const BlenderCall&, std::span<const Dual>);

}  // namespace burl
