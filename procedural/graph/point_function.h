#pragma once
// Functions of several numbers that other programs define: a step of a graph calls one for each
// point, on the host alone.
#include <algorithm>
#include <array>
#include <span>
#include <variant>

#include "procedural/blender/call.h"
#include "procedural/materialx/call.h"

namespace burl {

/// A function of a family with its settings.
using PointFunction = std::variant<BlenderCall, MaterialXCall>;

/// The largest number of numbers that a function takes.
inline constexpr std::size_t most_point_inputs =
    std::max(most_blender_inputs, most_materialx_inputs);

/// The results of a function: one to three numbers; those beyond its own are 0. Numbers that it
/// takes and that are not among `inputs` count as 0.
template <class T>
std::array<T, 3> point_value(const PointFunction& function, std::span<const T> inputs) {
    struct {
        std::span<const T> in;
        std::array<T, 3> operator()(const BlenderCall& call) const {
            return blender_value<T>(call, in);
        }
        std::array<T, 3> operator()(const MaterialXCall& call) const {
            return materialx_value<T>(call, in);
        }
    } const value{inputs};
    return std::visit(value, function);
}

}  // namespace burl
