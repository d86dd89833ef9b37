// The nodes of colours averaged over a footprint, as graph/colors.cpp and graph/noise.cpp define
// them.
#include <fmt/format.h>

#include "procedural/color/marble_spline.h"
#include "procedural/glsl/duals.h"

namespace burl {

namespace {

/// The channels of a variable of type DualColor, with alpha 1.
GlslNode opaque(const GlslNodeCall& call, const std::string& color) {
    return {{fmt::format("{}.r", color), fmt::format("{}.g", color), fmt::format("{}.b", color),
             call.text->constant(1.0)}};
}

GlslNode color_map(const GlslNodeCall& call) {
    GlslDuals& text = *call.text;
    const std::string map =
        text.filtering()->maps.add(call.graph->textures[call.node->texture].colors);
    const std::string f = call.input(0);
    const FilterKind kind = text.filtering()->filter.kind;
    const bool both = kind == FilterKind::trapezoid || kind == FilterKind::trapezoid2;
    return opaque(call, text.variable("DualColor",
                                      fmt::format("dual_color({}, {}, {}, {}, {})", map, f,
                                                  text.along(f, 'u'), text.along(f, 'v'), both)));
}

GlslNode layer_over(const GlslNodeCall& call) {
    GlslDuals& text = *call.text;
    const std::string opacity = text.dual(fmt::format(
        "dual_min({}, dual_max({}, {}))", text.constant(1.0), text.constant(0.0), call.input(2)));
    const std::string shows = text.dual(
        fmt::format("{} - dual_product({}, {})", text.constant(1.0), opacity, call.input(0, 3)));
    return call.channels([&](std::size_t c) {
        return fmt::format("dual_product({}, {}) + dual_product({}, {})", opacity, call.input(0, c),
                           shows, call.input(1, c));
    });
}

GlslNode uv(const GlslNodeCall& call) {
    GlslDuals& text = *call.text;
    const auto fraction = [&](std::size_t i) {
        return text.dual(
            fmt::format("box_fract({}, {})", call.axis(i), text.box_width(call.axis(i))));
    };
    const std::string u = fraction(0);
    return {{u, fraction(1), text.constant(0.0), text.constant(1.0)}};
}

/// The text "real3[9](...)" of the control points times the brightness.
std::string marble_points(const GlslDuals& text) {
    std::string list;
    for (const auto& color : marble_colors)
        list += fmt::format("{}real3({}, {}, {})", list.empty() ? "" : ", ",
                            text.number(marble_brightness * color[0]),
                            text.number(marble_brightness * color[1]),
                            text.number(marble_brightness * color[2]));
    return fmt::format("real3[{}]({})", marble_colors.size(), list);
}

GlslNode marble(const GlslNodeCall& call) {
    GlslDuals& text = *call.text;
    const double scale = call.parameter("scale");
    const std::string noise = glsl_octaves_at(call, Vec3d(scale));
    const std::string vein =
        text.dual(fmt::format("{} * {} + {} * {}", text.number(scale), call.axis(1),
                              glsl_operand(text.number(call.parameter("variation"))), noise));
    const std::string t = text.dual(
        fmt::format("{} + {} * dual_sin({})", text.constant(0.5), text.number(0.5), vein));
    return opaque(call, text.variable("DualColor",
                                      fmt::format("dual_spline({}, {}, {})", t, marble_points(text),
                                                  call.parameter("spline") == 1.0)));
}

/// The text "real2(...)" of the change of the first two coordinates along a step.
std::string moved(const GlslNodeCall& call, char step) {
    return fmt::format("real2({}, {})", call.text->along(call.axis(0), step),
                       call.text->along(call.axis(1), step));
}

GlslNode image(const GlslNodeCall& call) {
    GlslDuals& text = *call.text;
    const auto& pixels = call.graph->images[call.node->image].pixels;
    const std::string at = fmt::format("{}, {}, {}.x, {}.x", text.functions().image(pixels),
                                       pixels->levels().size(), call.axis(0), call.axis(1));
    const int wrap = int(call.parameter("wrap"));
    const std::string u = moved(call, 'u'), v = moved(call, 'v');
    const std::string sample =
        call.parameter("lookup") == 1.0
            ? fmt::format("ewa_sample({}, {}, {}, {}, {})", at, u, v,
                          text.number(call.parameter("anisotropy")), wrap)
            : fmt::format("trilinear_sample({}, trilinear_width({}, {}), {})", at, u, v, wrap);
    return opaque(call, text.variable("DualColor", fmt::format("dual_image({}, {}, {})", sample,
                                                               call.axis(0), call.axis(1))));
}

constexpr std::array colors_table{NamedGlslNode{"color_map", color_map},
                                  NamedGlslNode{"layer_over", layer_over}, NamedGlslNode{"uv", uv},
                                  NamedGlslNode{"marble", marble}, NamedGlslNode{"image", image}};

}  // namespace

std::span<const NamedGlslNode> glsl_color_nodes() {
    return colors_table;
}

}  // namespace burl
