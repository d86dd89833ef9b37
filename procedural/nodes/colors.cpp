// Colours: the map of the 1999 model over any number, Porter and Duff's "over" (1984), layers that
// blend as those of PDF and the web do, and pbrt's image texture.
#include "procedural/graph/node_ops.h"

namespace burl::nodes {

namespace {

Outputs color_map(NodeOps& node) {
    const ColorMap& map = node.texture().colors;
    if (is_opaque(map)) return node.opaque(MapColors{&map}, {node.input(0)});
    return node.with_alpha(MapColors{&map}, MapColors{&map, true}, {node.input(0)});
}

Outputs layer_over(NodeOps& node) {
    const Register opacity = node.clamped(node.input(2));
    const Register shows = node.linear(-1.0, node.multiply(opacity, node.input(0, 3)), 1.0);
    Outputs result;
    for (std::size_t c = 0; c < 4; ++c)
        result.push_back(
            node.apply(ValueOp::products, {opacity, node.input(0, c), shows, node.input(1, c)}));
    return result;
}

/// The modes of `blend`, in the order of its choices.
enum class BlendMode { normal, multiply, screen, overlay, add, darken, lighten, soft_light };

/// One channel of two layers, each multiplied by its layer's alpha. Numbers are opaque, which the
/// program's constants fold to nothing.
struct BlendPair {
    Register top, base, top_alpha, base_alpha;
};

/// A weight: 1 where `channel`, a channel times alpha, is above 1/2, else 0.
Register is_light(NodeOps& node, Register channel, Register alpha) {
    return node.apply(ValueOp::at_least, {node.combine(2.0, channel, -1.0, alpha)}, {0.0});
}

/// 2 top base where the base is dark, and the same of what they lack of white where it is light.
Register overlay(NodeOps& node, const BlendPair& pair) {
    const auto [top, base, top_alpha, base_alpha] = pair;
    const Register dark = node.linear(2.0, node.multiply(top, base));
    const Register lacks = node.multiply(node.combine(1.0, base_alpha, -1.0, base),
                                         node.combine(1.0, top_alpha, -1.0, top));
    const Register light = node.combine(1.0, node.multiply(top_alpha, base_alpha), -2.0, lacks);
    return node.lerp(is_light(node, base, base_alpha), dark, light);
}

/// The base x moved by 2 top - 1 of the way to D(x), which is ((16 x - 12) x + 4) x up to 1/4 and
/// sqrt(x) from there on, or to x^2 where the top is dark.
Register soft_light(NodeOps& node, const BlendPair& pair) {
    const auto [top, base, top_alpha, base_alpha] = pair;
    const Register x = node.ratio(base, base_alpha);
    const Register cubic =
        node.multiply(x, node.linear(1.0, node.multiply(x, node.linear(16.0, x, -12.0)), 4.0));
    const Register root = node.apply(ValueOp::power, {node.maximum(x, node.constant(0.25))}, {0.5});
    const Register beyond = node.apply(ValueOp::at_least, {x}, {0.25});
    const Register lighter = node.combine(1.0, node.lerp(beyond, cubic, root), -1.0, x);
    const Register darker = node.combine(1.0, x, -1.0, node.multiply(x, x));
    const Register way = node.lerp(is_light(node, top, top_alpha), darker, lighter);
    const Register share = node.multiply(base_alpha, node.combine(2.0, top, -1.0, top_alpha));
    return node.apply(ValueOp::products, {top_alpha, base, share, way});
}

/// Both alphas times the blend of the straight colours.
Register blended(NodeOps& node, BlendMode mode, const BlendPair& pair) {
    const auto [top, base, top_alpha, base_alpha] = pair;
    const Register both = node.multiply(top, base);
    const Register here = node.multiply(top, base_alpha), there = node.multiply(base, top_alpha);
    switch (mode) {
        case BlendMode::normal:
            return here;
        case BlendMode::multiply:
            return both;
        case BlendMode::screen:
            return node.combine(1.0, node.apply(ValueOp::add, {here, there}), -1.0, both);
        case BlendMode::overlay:
            return overlay(node, pair);
        case BlendMode::add:
            return node.apply(ValueOp::add, {here, there});
        case BlendMode::darken:
            return node.minimum(here, there);
        case BlendMode::lighten:
            return node.maximum(here, there);
        case BlendMode::soft_light:
            return soft_light(node, pair);
    }
    return here;
}

/// Where the base is transparent the top shows as it is; where the top is, the base.
Outputs blend_layers(NodeOps& node) {
    const auto mode = BlendMode(int(node.parameter("mode")));
    const bool color = node.channels() == 4;
    const Register one = node.constant(1.0);
    const Register top_alpha = color ? node.input(0, 3) : one;
    const Register base_alpha = color ? node.input(1, 3) : one;
    const Register opacity =
        node.multiply(node.clamped(node.input(2)), node.clamped(node.input(3)));
    const Register shows = node.linear(-1.0, node.multiply(opacity, top_alpha), 1.0);
    const Register alone = node.linear(-1.0, base_alpha, 1.0);
    Outputs result;
    for (std::size_t c = 0; c < (color ? 3 : 1); ++c) {
        const Register top = node.input(0, c), base = node.input(1, c);
        const Register both = blended(node, mode, {top, base, top_alpha, base_alpha});
        const Register layer = node.apply(ValueOp::products, {top, alone, both, one});
        result.push_back(node.apply(ValueOp::products, {opacity, layer, shows, base}));
    }
    if (color)
        result.push_back(node.apply(ValueOp::products, {opacity, top_alpha, shows, base_alpha}));
    return result;
}

Outputs image(NodeOps& node) {
    const ImageColors colors{node.image().pixels, node.parameter("lookup") == 1.0,
                             node.parameter("anisotropy")};
    const std::vector<Register> at{node.axis(0), node.axis(1)};
    if (!colors.pixels->alpha()) return node.opaque(colors, at);
    ImageColors alpha = colors;
    alpha.pixels = {colors.pixels, colors.pixels->alpha()};
    return node.with_alpha(colors, alpha, at);
}

constexpr std::array color_rows{
    a_node("color_map", NodeResult::color, color_map,
           "colour `stops` over a number, index repeated or clamped (`wrap`)", "Hart et al. 1999",
           one_number),
    a_node("layer_over", NodeResult::color, layer_over,
           "top over base by top's alpha times opacity", "Porter and Duff 1984",
           {a_color("top", "the upper layer"), a_color("base", "what it covers"),
            a_number("opacity", "factor of top's alpha, clamped to [0,1]", "1")}),
    a_node("blend", NodeResult::inputs, blend_layers,
           "top over base by opacity times mask, in one of the modes of PDF and the web",
           "W3C Compositing 2015",
           {any("top", "the upper layer"), any("base", "what it lies on"),
            a_number("opacity", "share of the layer, clamped to [0,1]", "1"),
            a_number("mask", "factor of opacity, clamped to [0,1]", "1")},
           {one_of("mode", "\"normal\"",
                   "normal|multiply|screen|overlay|add|darken|lighten|soft_light",
                   "how the top changes the base; in linear light")}),
    a_node("image", NodeResult::color, image,
           "an image over [0,1]^2 of the point's first two coordinates, row 0 from 0 on", pbrt, {},
           {Parameter{"file", ParameterType::text, 0, 0, 0, 0, "", "", "",
                      "a PNG, JPEG or WebP, from the recipe's folder on"},
            one_of("lookup", "\"trilinear\"", "trilinear|ewa",
                   "between MIP levels, or an elliptically weighted average"),
            one_of("wrap", "\"repeat\"", "repeat|black|clamp", "what lies beyond the image"),
            real("anisotropy", 1, 32, "8", "most unequal axes of an ellipse; ewa only")}),
};

}  // namespace

std::span<const NodeType> colors() {
    return color_rows;
}

}  // namespace burl::nodes
