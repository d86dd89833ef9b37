// What the mesh's shape, and its file, say at a texel (docs/reference/masks.md): masks, of which a
// graph knows nothing but their numbers (masks.h).
#include "procedural/graph/node_ops.h"

namespace burl::nodes {

namespace {

Outputs mask_alone(NodeOps& node) {
    return {node.mask()};
}

/// The curvature, or how much of it bulges or is hollow.
Outputs mask_curvature(NodeOps& node) {
    const Register both = node.mask();
    const double gives = node.parameter("gives");
    if (gives == 0.0) return {both};
    return {node.maximum(node.constant(0.0), gives == 1.0 ? both : node.linear(-1.0, both))};
}

/// The file's colour, which is not multiplied by its alpha.
Outputs mask_vertex_color(NodeOps& node) {
    Outputs color{node.mask(0), node.mask(1), node.mask(2)};
    if (node.parameter("alpha") == 0.0) {
        color.push_back(node.constant(1.0));
        return color;
    }
    const Register alpha = node.clamped(node.mask(3));
    for (Register& channel : color) channel = node.multiply(alpha, channel);
    color.push_back(alpha);
    return color;
}

Outputs mask_mesh_uv(NodeOps& node) {
    return {node.mask(0), node.mask(1), node.constant(0.0)};
}

/// The light of both halves of the sky and of the sun. Colours that are transparent shine less.
Outputs mask_lighting(NodeOps& node) {
    const double sky = node.parameter("sky_strength"), sun = node.parameter("sun_strength");
    Outputs color;
    for (std::size_t c = 0; c < 3; ++c) {
        const Register of_sky = node.apply(
            ValueOp::products, {node.mask(0), node.input(0, c), node.mask(1), node.input(1, c)});
        color.push_back(
            node.combine(sky, of_sky, sun, node.multiply(node.mask(2), node.input(2, c))));
    }
    color.push_back(node.constant(1.0));
    return color;
}

constexpr NodeType a_mask(std::string_view name, NodeMask mask, Outputs (*define)(NodeOps&),
                          std::string_view text, std::string_view source,
                          const Parameters& parameters = {}) {
    NodeType type = a_node(name, NodeResult::number, define, text, source, {}, parameters);
    type.mask = mask;
    return type;
}

constexpr NodeType colored(NodeType type) {
    type.result = NodeResult::color;
    return type;
}

/// A mask whose inputs its components multiply.
constexpr NodeType weighing(NodeType type, const Inputs& inputs) {
    type.input_list = inputs;
    return colored(type);
}

constexpr NodeType mapping(NodeType type) {
    type.result = NodeResult::inner;
    type.input_list = moved_input;
    return type;
}

/// A length in units of the graph's solid point.
constexpr Parameter length(std::string_view key, double low, std::string_view otherwise,
                           std::string_view tip) {
    return real(key, low, 1e6, otherwise, tip);
}

constexpr std::array mask_rows{
    a_mask("occlusion", {MaskKind::occlusion, 1, 2}, mask_alone,
           "share of the sky that the texel's point sees: 1 open, 0 closed",
           "Zhukov, Iones, Kronin 1998",
           {whole("rays", 1, 4096, "128", "per point; more are less noisy"),
            length("distance", 1e-6, "null", "what lies farther off hides nothing; null: no end")}),
    a_mask("curvature", {MaskKind::curvature, 1, 1}, mask_curvature,
           "mean curvature times radius: 1 convex, 0 flat, -1 hollow", "Clarenz, Rumpf, Telea 2004",
           {length("radius", 1e-6, "0.05", "how far round the point the surface counts"),
            one_of("gives", "\"both\"", "both|convex|concave",
                   "both; or what is convex, or concave, from 0 to 1")}),
    a_mask(
        "thickness", {MaskKind::thickness, 1, 2}, mask_alone,
        "mean length of rays into the solid up to its other side, at most distance",
        "Shapira, Shamir, Cohen-Or 2008",
        {whole("rays", 1, 4096, "64", "per point; more are less noisy"),
         length("distance", 1e-6, "null", "longer rays count as this; null: the box's diagonal")}),
    a_mask("facing", {MaskKind::facing, 1, 3}, mask_alone,
           "cosine between the surface's normal and direction, in the mesh's axes", own,
           {several("direction", 3, "[0,1,0]", "any length above 0")}),
    a_mask("height_in_box", {MaskKind::height_in_box, 1, 1}, mask_alone,
           "height in the mesh's box along an axis of the mesh, 0 to 1", own,
           {one_of("axis", "\"y\"", "x|y|z", "the mesh's own")}),
    a_mask("edge_distance", {MaskKind::edge_distance, 1, 2}, mask_alone,
           "distance to the nearest crease or border of the mesh, at most farthest", own,
           {real("angle", 0, 180, "30", "degrees by which normals differ across a crease"),
            length("farthest", 1e-6, "null", "null: the box's diagonal")}),
    a_mask("part", {MaskKind::part, 1, 2}, mask_alone,
           "a random number in [0,1) of the piece of the mesh", own,
           {one_of("piece", "\"connected\"", "connected|part",
                   "what hangs together, or each part of the file"),
            whole("seed", 0, 4294967295.0, "0", "number of the random choice")}),
    a_mask("paint", {MaskKind::paint, 1, 1}, mask_alone,
           "how far strokes of a layer of paint cover the point, 0 to 1", own,
           {whole("layer", 1, 99, "1", "the layer of the strokes, which no other colour shows")}),
    colored(a_mask("vertex_color", {MaskKind::vertex_color, 4, 0}, mask_vertex_color,
                   "the file's colour at the point; white where it has none", own,
                   {one_of("alpha", "\"opaque\"", "opaque|file", "alpha is 1, or the file's")})),
    weighing(
        a_mask(
            "lighting", {MaskKind::lighting, 3, 10}, mask_lighting,
            "diffuse light at the texel, in the shadow of the mesh: of a sky with two halves and "
            "of a sun",
            "Carr and Hart 2001",
            {whole("rays", 1, 4096, "128", "per point, to the sky; more are less noisy"),
             length("distance", 1e-6, "null",
                    "what lies farther off does not hide the sky; null: no end"),
             several("up", 3, "[0,1,0]", "towards the sky's upper half, in the mesh's axes"),
             several("direction", 3, "[0.4,0.8,0.6]",
                     "towards the sun, in the mesh's axes; any length above 0"),
             real("angle", 0, 90, "2", "radius of the sun in degrees; 0: sharp shadows"),
             real("crease", 0, 180, "40",
                  "degrees above which computed normals split, of a mesh that has none"),
             real("sky_strength", 0, 1e6, "1", "factor of sky and ground"),
             real("sun_strength", 0, 1e6, "0.8", "light on what faces the sun, as a factor")}),
        {a_color("sky", "the sky's upper half", "\"#7f8fa6\""),
         a_color("ground", "the sky's lower half", "\"#4a423a\""),
         a_color("sun", "the sun", "\"#fff0d8\"")}),
    mapping(a_mask("mesh_uv", {MaskKind::mesh_uv, 2, 0}, mask_mesh_uv,
                   "(u, v, 0) of the mesh's own texture coordinates, row 0 at v = 0; 0 where it "
                   "has none",
                   own)),
};

}  // namespace

std::span<const NodeType> masks() {
    return mask_rows;
}

}  // namespace burl::nodes
