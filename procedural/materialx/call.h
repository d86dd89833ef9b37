#pragma once
// MaterialX's functions behind one door: which function, its settings, and numbers in and out.
// Graphs evaluate their steps by it (procedural/graph/point_function.h).
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "procedural/numbers/dual.h"

namespace burl {

/// MaterialX's functions of several numbers, and the numbers that each takes, in their order.
enum class MaterialXFunction : std::uint8_t {
    noise,        ///< point: as many as `results`
    fractal,      ///< point, octaves, lacunarity, diminish: as many as `results`
    cell_noise,   ///< point: as many as `results`
    worley,       ///< point, jitter: as many as `results`; choice: the style
    math,         ///< three numbers; choice: the operation: 1
    vector_math,  ///< three vectors; choice: the operation: 3
};

/// The largest number of numbers that a function takes.
inline constexpr std::size_t most_materialx_inputs = 9;

/// A function with its settings.
struct MaterialXCall {
    MaterialXFunction function = MaterialXFunction::math;
    int choice = 0;      ///< operation (materialx/math.h) or style (materialx/noise.h)
    int dimensions = 3;  ///< of a noise: 2, those of x and y, or 3
    int results = 1;     ///< of a noise: 1 or 3
    bool operator==(const MaterialXCall&) const = default;
};

/// The results of a call: one to three numbers; those beyond a function's own are 0. Numbers that
/// the function takes and that are not among `inputs` count as 0.
template <class T>
std::array<T, 3> materialx_value(const MaterialXCall& call, std::span<const T> inputs);

extern template std::array<double, 3> materialx_value(const MaterialXCall&,
                                                      std::span<const double>);
extern template std::array<Dual, 3> materialx_value(const MaterialXCall&, std::span<const Dual>);

}  // namespace burl
