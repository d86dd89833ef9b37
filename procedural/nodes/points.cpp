// Where other nodes are evaluated: pbrt's texture mappings and affine maps. Slopes follow by the
// chain rule, so that they go on across the seams of the round mappings, which finite differences
// (the slides' way) have to repair.
#include <numbers>

#include "procedural/graph/node_ops.h"
#include "procedural/numbers/rotation.h"

namespace burl::nodes {

namespace {

using std::numbers::pi;

/// The affine map p -> matrix (translate + rotate_z rotate_y rotate_x scale p).
Affine3 transform_map(const NodeParameters& node) {
    const Vec3d factors = node.vector("scale"), degrees = node.vector("rotate");
    Affine3 inner{Mat3d(1.0), node.vector("translate")}, outer;
    for (int axis = 0; axis < 3; ++axis) inner.linear[axis] *= factors[axis];
    for (int axis = 0; axis < 3; ++axis)
        inner.linear = rotation_about(axis, degrees[axis]) * inner.linear;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            outer.linear[column][row] = node.parameter("matrix", std::size_t(4 * row + column));
        outer.offset[row] = node.parameter("matrix", std::size_t(4 * row + 3));
    }
    return outer.after(inner);
}

Outputs transform(NodeOps& node) {
    return node.moved(transform_map(node));
}

Vec3d plane_offset(const NodeParameters& node) {
    return {node.parameter("offset", 0), node.parameter("offset", 1), 0.0};
}

Outputs map_uv(NodeOps& node) {
    Affine3 map{Mat3d(1.0), plane_offset(node)};
    for (int i = 0; i < 2; ++i) map.linear[i][i] = node.parameter("scale", std::size_t(i));
    return node.moved(map);
}

Outputs map_spherical(NodeOps& node) {
    const Register away = node.length(node.axis(0), node.axis(1));
    const Register turn = node.linear(0.5 / pi, node.angle(node.axis(1), node.axis(0)));
    const Register positive = node.apply(PositiveTurn{}, {turn});
    const Register down = node.linear(1.0 / pi, node.angle(away, node.axis(2)));
    return {down, positive, node.length(away, node.axis(2))};
}

Outputs map_cylindrical(NodeOps& node) {
    const Register away = node.length(node.axis(0), node.axis(1));
    Register height = node.axis(2);
    if (node.parameter("height") == 1.0)
        height = node.apply(ValueOp::ratio, {height, node.length(away, height)});
    const Register angle = node.angle(node.axis(1), node.axis(0));
    return {node.linear(0.5 / pi, angle, 0.5), height, away};
}

Outputs map_planar(NodeOps& node) {
    const Mat3d rows(node.vector("vs"), node.vector("vt"), Vec3d(0.0));
    return node.moved({glm::transpose(rows), plane_offset(node)});
}

constexpr std::array point_rows{
    a_node("transform", NodeResult::inner, transform,
           "matrix (translate + rotate scale point); pbrt's 3-D mapping", pbrt, moved_input,
           {several("scale", 3, "[1,1,1]", "factors of the coordinates"),
            several("rotate", 3, "[0,0,0]", "degrees about the first, second and third axis"),
            several("translate", 3, "[0,0,0]", "added"),
            several("matrix", 12, "[1,0,0,0,0,1,0,0,0,0,1,0]", "3 rows of 4, applied last")}),
    a_node("map_uv", NodeResult::inner, map_uv,
           "(scale u + offset, third coordinate) of the point's first two, u", pbrt, moved_input,
           {several("scale", 2, "[1,1]", "factors"), several("offset", 2, "[0,0]", "added")}),
    a_node("map_spherical", NodeResult::inner, map_spherical,
           "(angle from the r axis / pi, turn about it in [0,1), distance)", pbrt, moved_input),
    a_node("map_cylindrical", NodeResult::inner, map_cylindrical,
           "(turn about the r axis in [0,1], height, distance from it)", pbrt, moved_input,
           {one_of("height", "\"axis\"", "axis|normalized",
                   "r itself, or (pbrt) r over the distance from the origin")}),
    a_node(
        "map_planar", NodeResult::inner, map_planar, "(vs . point, vt . point, 0) + offset", pbrt,
        moved_input,
        {several("vs", 3, "[1,0,0]", "gives the first coordinate"),
         several("vt", 3, "[0,1,0]", "gives the second"), several("offset", 2, "[0,0]", "added")}),
};

}  // namespace

std::span<const NodeType> points() {
    return point_rows;
}

}  // namespace burl::nodes
