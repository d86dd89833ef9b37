// Colours: the map of the 1999 model over any number, Porter and Duff's "over" (1984), and pbrt's
// image texture.
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
    a_node("image", NodeResult::color, image,
           "an image over [0,1]^2 of the point's first two coordinates, row 0 from 0 on", pbrt, {},
           {Parameter{"file", ParameterType::text, 0, 0, 0, 0, "", "", "",
                      "a PNG, from the recipe's folder on"},
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
