// The nodes of numbers, weighted sums and mappings with their gradients, as graph/math.cpp and
// graph/mappings.cpp define them.
#include <numbers>

#include <fmt/format.h>

#include "procedural/color/srgb.h"
#include "procedural/glsl/duals.h"
#include "procedural/graph/affine.h"

namespace burl {

namespace {

constexpr double pi = std::numbers::pi;

GlslNode constant(const GlslNodeCall& call) {
    const std::vector<double>& p = call.node->parameters;
    if (call.node->wire != Wire::color) return {{call.text->constant(p[0])}};
    const double alpha = p[3] / 255.0;
    GlslNode result;
    for (std::size_t c = 0; c < 3; ++c)
        result.channels.push_back(call.text->constant(alpha * srgb_decode(p[c] / 255.0)));
    result.channels.push_back(call.text->constant(alpha));
    return result;
}

GlslNode coordinate(const GlslNodeCall& call) {
    return call.number(call.along(call.vector("direction"), call.parameter("offset")));
}

GlslNode add(const GlslNodeCall& call) {
    return call.number(fmt::format("{} + {}", call.input(0), call.input(1)));
}

/// The node "FUNCTION(input 0)", or "FUNCTION(input 0, input 1)" if `two`.
GlslNode apply(const GlslNodeCall& call, const char* function, bool two = false) {
    return call.number(two ? fmt::format("{}({}, {})", function, call.input(0), call.input(1))
                           : fmt::format("{}({})", function, call.input(0)));
}

GlslNode multiply(const GlslNodeCall& call) {
    return apply(call, "dual_product", true);
}
GlslNode minimum(const GlslNodeCall& call) {
    return apply(call, "dual_min", true);
}
GlslNode maximum(const GlslNodeCall& call) {
    return apply(call, "dual_max", true);
}
GlslNode absolute(const GlslNodeCall& call) {
    return apply(call, "dual_abs");
}
GlslNode sine_of(const GlslNodeCall& call) {
    return apply(call, "dual_sin");
}
GlslNode floor_of(const GlslNodeCall& call) {
    return apply(call, "dual_floor");
}
GlslNode fract_of(const GlslNodeCall& call) {
    return apply(call, "dual_fract");
}

GlslNode power(const GlslNodeCall& call) {
    const double e = call.parameter("exponent");
    if (e == 0.0) return {{call.text->constant(1.0)}};
    if (e == std::floor(e))
        return call.number(fmt::format("dual_whole_power({}, {}u)", call.input(0), e));
    return call.number(fmt::format("dual_power({}, {})", call.input(0), call.text->number(e)));
}

/// The slope of the input along a direction; the gradient of the slope itself counts as 0.
GlslNode slope(const GlslNodeCall& call) {
    const Vec3d d = call.vector("direction");
    return call.number(fmt::format("dual(dot_of(real3({}, {}, {}), {}.yzw))",
                                   call.text->number(d.x), call.text->number(d.y),
                                   call.text->number(d.z), call.input(0)));
}

GlslNode smoothstep(const GlslNodeCall& call) {
    return call.number(fmt::format("dual_smoothstep({}, {}, {})",
                                   call.text->number(call.parameter("low")),
                                   call.text->number(call.parameter("high")), call.input(0)));
}

GlslNode scale(const GlslNodeCall& call) {
    return call.channels([&](std::size_t c) {
        return fmt::format("dual_product({}, {})", call.input(0, c), call.input(1, c));
    });
}

GlslNode mix(const GlslNodeCall& call) {
    return call.blend(call.input(2));
}

GlslNode bilerp(const GlslNodeCall& call) {
    return call.channels([&](std::size_t c) {
        return fmt::format("dual_lerp({0}, dual_lerp({1}, {2}, {3}), dual_lerp({1}, {4}, {5}))",
                           call.axis(0), call.axis(1), call.input(0, c), call.input(1, c),
                           call.input(2, c), call.input(3, c));
    });
}

GlslNode transform(const GlslNodeCall& call) {
    NodeCall node;
    node.node = call.node;
    const Affine3 map = transform_map(node);
    const Mat3d rows = glm::transpose(map.linear);
    GlslNode result;
    for (int i = 0; i < 3; ++i)
        result.channels.push_back(call.text->dual(call.along(rows[i], map.offset[i])));
    return result;
}

GlslNode map_uv(const GlslNodeCall& call) {
    GlslNode result;
    for (std::size_t i = 0; i < 2; ++i) {
        Vec3d d(0.0);
        d[int(i)] = call.parameter("scale", i);
        result.channels.push_back(call.text->dual(call.along(d, call.parameter("offset", i))));
    }
    result.channels.push_back(call.axis(2));
    return result;
}

GlslNode map_planar(const GlslNodeCall& call) {
    return {{call.text->dual(call.along(call.vector("vs"), call.parameter("offset", 0))),
             call.text->dual(call.along(call.vector("vt"), call.parameter("offset", 1))),
             call.text->constant(0.0)}};
}

std::string off_axis(const GlslNodeCall& call) {
    return call.text->dual(fmt::format("dual_length({}, {})", call.axis(0), call.axis(1)));
}

GlslNode map_spherical(const GlslNodeCall& call) {
    GlslDuals& text = *call.text;
    const std::string away = off_axis(call);
    const std::string turn = text.dual(
        fmt::format("{} * dual_angle({}, {})", text.number(0.5 / pi), call.axis(1), call.axis(0)));
    return {{text.dual(
                 fmt::format("{} * dual_angle({}, {})", text.number(1.0 / pi), away, call.axis(2))),
             text.dual(fmt::format("{0}.x < {1} ? {0} + {2} : {0}", turn, text.number(0.0),
                                   text.constant(1.0))),
             text.dual(fmt::format("dual_length({}, {})", away, call.axis(2)))}};
}

GlslNode map_cylindrical(const GlslNodeCall& call) {
    GlslDuals& text = *call.text;
    const std::string away = off_axis(call);
    std::string height = call.axis(2);
    if (call.parameter("height") == 1.0)
        height = text.dual(fmt::format("dual_ratio({0}, dual_length({1}, {0}))", height, away));
    return {{text.dual(fmt::format("{} + {} * dual_angle({}, {})", text.constant(0.5),
                                   text.number(0.5 / pi), call.axis(1), call.axis(0))),
             height, away}};
}

constexpr std::array math_table{NamedGlslNode{"constant", constant},
                                NamedGlslNode{"coordinate", coordinate},
                                NamedGlslNode{"add", add},
                                NamedGlslNode{"multiply", multiply},
                                NamedGlslNode{"min", minimum},
                                NamedGlslNode{"max", maximum},
                                NamedGlslNode{"abs", absolute},
                                NamedGlslNode{"power", power},
                                NamedGlslNode{"sin", sine_of},
                                NamedGlslNode{"slope", slope},
                                NamedGlslNode{"floor", floor_of},
                                NamedGlslNode{"fract", fract_of},
                                NamedGlslNode{"smoothstep", smoothstep},
                                NamedGlslNode{"scale", scale},
                                NamedGlslNode{"mix", mix},
                                NamedGlslNode{"bilerp", bilerp},
                                NamedGlslNode{"transform", transform},
                                NamedGlslNode{"map_uv", map_uv},
                                NamedGlslNode{"map_planar", map_planar},
                                NamedGlslNode{"map_spherical", map_spherical},
                                NamedGlslNode{"map_cylindrical", map_cylindrical}};

}  // namespace

std::span<const NamedGlslNode> glsl_math_nodes() {
    return math_table;
}

}  // namespace burl
