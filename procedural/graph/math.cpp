// The nodes of numbers and arithmetic, and the weighted sums of pbrt's scale, mix and bilerp
// textures, which leave filtering to their inputs.
#include "procedural/color/srgb.h"
#include "procedural/graph/nodes.h"

namespace burl::nodes {

namespace {

/// Applies a function of one number to the input at every point.
template <class Function>
void map_number(const NodeCall& call, Function&& function) {
    for_each_point(call, [&](std::size_t i) { return function(call.input(0, i)); });
}

/// Applies a function of two numbers to the inputs at every point.
template <class Function>
void map_numbers(const NodeCall& call, Function&& function) {
    for_each_point(call,
                   [&](std::size_t i) { return function(call.input(0, i), call.input(1, i)); });
}

}  // namespace

void constant(const NodeCall& call) {
    const std::vector<double>& p = call.node->parameters;
    const bool color = call.out.size() == 4;
    const double alpha = color ? p[3] / 255.0 : 1.0;
    for (std::size_t c = 0; c < call.out.size(); ++c) {
        const Dual value = !color ? p[0] : c < 3 ? alpha * srgb_decode(p[c] / 255.0) : alpha;
        for (std::size_t i = 0; i < call.count(); ++i) call.out[c].set(i, value);
    }
}

void coordinate(const NodeCall& call) {
    const Vec3d d = call.vector("direction");
    const double offset = call.parameter("offset");
    for_each_point(call, [&](std::size_t i) {
        const DualPoint p = call.point(i);
        return d.x * p.x + d.y * p.y + d.z * p.z + offset;
    });
}

void add(const NodeCall& call) {
    map_numbers(call, [](const Dual& a, const Dual& b) { return a + b; });
}

void multiply(const NodeCall& call) {
    map_numbers(call, [](const Dual& a, const Dual& b) { return a * b; });
}

void minimum(const NodeCall& call) {
    map_numbers(call, dual_min);
}

void maximum(const NodeCall& call) {
    map_numbers(call, dual_max);
}

void absolute(const NodeCall& call) {
    map_number(call, dual_abs);
}

void power(const NodeCall& call) {
    const double exponent = call.parameter("exponent");
    map_number(call, [exponent](const Dual& x) { return dual_power(x, exponent); });
}

void sine_of(const NodeCall& call) {
    map_number(call, dual_sin);
}

void slope(const NodeCall& call) {
    const Vec3d d = call.vector("direction");
    map_number(call, [&](const Dual& x) -> Dual { return glm::dot(d, x.slope); });
}

void floor_of(const NodeCall& call) {
    map_number(call, dual_floor);
}

void fract_of(const NodeCall& call) {
    map_number(call, dual_fract);
}

void smoothstep(const NodeCall& call) {
    const double low = call.parameter("low"), high = call.parameter("high");
    map_number(call, [&](const Dual& x) { return dual_smoothstep(low, high, x); });
}

void scale(const NodeCall& call) {
    for_each_channel(call, [&](std::size_t i, std::size_t c) {
        return call.input(0, i, c) * call.input(1, i, c);
    });
}

void mix(const NodeCall& call) {
    blend_inputs(call, [&](std::size_t i) { return call.input(2, i); });
}

void bilerp(const NodeCall& call) {
    for_each_channel(call, [&](std::size_t i, std::size_t c) {
        const DualPoint p = call.point(i);
        return dual_lerp(p.x, dual_lerp(p.y, call.input(0, i, c), call.input(1, i, c)),
                         dual_lerp(p.y, call.input(2, i, c), call.input(3, i, c)));
    });
}

}  // namespace burl::nodes
