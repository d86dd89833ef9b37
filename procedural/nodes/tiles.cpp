// Patterns of tiles, cells and strewn shapes, each of which has a random number of its own. A tile
// ends where its joint begins; joints are as wide as `joint` between tiles.
#include <algorithm>
#include <numbers>

#include "procedural/graph/node_ops.h"

namespace burl::nodes {

namespace {

/// The tile around a point.
struct Tile {
    Register shown;  ///< 1 on the tile and 0 in its joint, over the footprint
    Register edge;   ///< distance to the tile's border, negative in the joint
    Outputs cell;    ///< whole numbers that no other tile has
    Register u, v;   ///< coordinates in the tile, 0 to 1 from joint's middle to joint's middle
};

Register of(NodeOps& node, ValueOp function, Register x) {
    return node.apply(function, {x});
}
Register floor_of(NodeOps& node, Register x) {
    return of(node, ValueOp::floor, x);
}
Register smaller(NodeOps& node, Register a, Register b) {
    return node.apply(ValueOp::minimum, {a, b});
}
Register larger(NodeOps& node, Register a, Register b) {
    return node.apply(ValueOp::maximum, {a, b});
}
Register difference(NodeOps& node, Register a, Register b) {
    return node.combine(1.0, a, -1.0, b);
}

std::uint32_t seed_of(const NodeParameters& node) {
    return std::uint32_t(node.parameter("seed"));
}

/// The distance to the nearer end of a segment of length `size`, less half the joint, at a place in
/// it, 0 to 1.
Register within(NodeOps& node, Register place, double size) {
    const Register away = of(node, ValueOp::absolute, node.linear(size, place, -0.5 * size));
    return node.linear(-1.0, away, 0.5 * (size - node.parameter("joint")));
}

/// The weight of a tile by the distance to its border, for tiles that cover the share `mean` of the
/// plane: exact over footprints that see one straight joint, whose two sides are two steps.
/// Footprints wider than `widest` see the mean.
Register between_joints(NodeOps& node, Register edge, double mean, double widest) {
    const Register near = node.apply(BoxStep{1.0, 0.0, 0.0, mean, widest}, {edge}),
                   far =
                       node.apply(BoxStep{1.0, node.parameter("joint"), 0.0, 1.0, widest}, {edge});
    return node.linear(1.0, difference(node, near, far), 1.0);
}

/// The share that is left of a length without a joint.
double share_of(const NodeParameters& node, double size) {
    return std::max(1.0 - node.parameter("joint") / size, 0.0);
}

Outputs given(NodeOps& node, const Tile& tile) {
    const Register id = node.apply(CellNumber{seed_of(node)}, tile.cell);
    const std::array all{tile.shown, tile.edge, id, tile.u, tile.v};
    return node.blend(all[std::size_t(node.parameter("gives"))]);
}

/// How a course of boxes lies against the one below.
enum class Bond { aligned, stepped, random };

/// Courses of boxes; axis 2 counts where they have a depth. Joints are exact over footprints along
/// one axis and have the right mean over wide ones, because the weights of the axes are multiplied
/// (Apodaca and Gritz, "Advanced RenderMan", 1999).
Outputs boxes(NodeOps& node, Bond bond) {
    const std::array sizes{node.parameter("width"), node.parameter("height"),
                           node.parameter("depth")};
    const Register course = node.linear(1.0 / sizes[1], node.axis(1));
    const Register number = floor_of(node, course);
    const Register shift = bond == Bond::random
                               ? node.apply(CellNumber{seed_of(node) + 1}, {number})
                               : node.linear(node.parameter("offset"), number);
    Tile tile;
    Outputs places;
    for (std::size_t i = 0; i < (sizes[2] > 0.0 ? 3 : 2); ++i) {
        Register x = i == 1 ? course : node.linear(1.0 / sizes[i], node.axis(i));
        if (i != 1 && bond != Bond::aligned) x = node.combine(1.0, x, 1.0, shift);
        tile.cell.push_back(floor_of(node, x));
        places.push_back(of(node, ValueOp::fract, x));
        const double joint = std::min(node.parameter("joint") / sizes[i], 1.0);
        const Register edge = within(node, places[i], sizes[i]);
        const Register shown = node.apply(BoxPulse{joint}, {node.linear(1.0, x, 0.5 * joint)});
        tile.edge = i == 0 ? edge : smaller(node, tile.edge, edge);
        tile.shown = i == 0 ? shown : node.multiply(tile.shown, shown);
    }
    tile.u = places[0], tile.v = places[1];
    return given(node, tile);
}

Outputs squares(NodeOps& node) {
    return boxes(node, Bond::aligned);
}
Outputs bricks(NodeOps& node) {
    return boxes(node, Bond::stepped);
}
Outputs planks(NodeOps& node) {
    return boxes(node, Bond::random);
}

/// The middles of hexagons are the points of two lattices of rectangles, 1 : sqrt(3), one of which
/// is the other moved by half a rectangle: the nearest point of all is one of their two nearest.
Outputs hexagons(NodeOps& node) {
    const double width = node.parameter("width"), root3 = std::numbers::sqrt3;
    const std::array at{node.linear(1.0 / width, node.axis(0)),
                        node.linear(1.0 / (root3 * width), node.axis(1))};
    std::array<Register, 2> first, second, to_first, to_second, away;
    for (std::size_t i = 0; i < 2; ++i) {
        first[i] = floor_of(node, node.linear(1.0, at[i], 0.5));
        second[i] = node.linear(1.0, floor_of(node, at[i]), 0.5);
        to_first[i] = difference(node, at[i], first[i]);
        to_second[i] = difference(node, at[i], second[i]);
    }
    const auto square = [&](const std::array<Register, 2>& to) {
        return node.apply(ValueOp::products, {to[0], to[0], node.linear(3.0, to[1]), to[1]});
    };
    const Register farther = difference(node, square(to_first), square(to_second));
    const Register pick = node.apply(ValueOp::at_least, {farther}, {0.0});
    Tile tile;
    for (std::size_t i = 0; i < 2; ++i) {
        away[i] = node.lerp(pick, to_first[i], to_second[i]);
        tile.cell.push_back(node.linear(2.0, node.lerp(pick, first[i], second[i])));
    }
    const Register x = of(node, ValueOp::absolute, away[0]),
                   y = of(node, ValueOp::absolute, away[1]);
    const Register far = larger(node, x, node.combine(0.5, x, 1.5, y));
    tile.edge = node.linear(-width, far, 0.5 * (width - node.parameter("joint")));
    const double share = share_of(node, width);
    tile.shown = between_joints(node, tile.edge, share * share, width);
    tile.u = node.linear(1.0, away[0], 0.5);
    tile.v = node.linear(1.5, away[1], 0.5);
    return given(node, tile);
}

/// In units of a tile's width, tiles of length n lie on unit squares: square (i, j) belongs to one
/// along the first axis where k = (i - j) mod 2n is below n, which begins k squares before it, and
/// otherwise to one along the second axis, which begins 2n - 1 - k squares below it.
Outputs herringbone(NodeOps& node) {
    const double width = node.parameter("width"), n = node.parameter("ratio");
    const Register x = node.linear(1.0 / width, node.axis(0)),
                   y = node.linear(1.0 / width, node.axis(1));
    const Register i = floor_of(node, x), j = floor_of(node, y);
    const Register steps = difference(node, i, j);
    const Register turns = floor_of(node, node.linear(0.5 / n, steps, 0.25 / n));
    const Register k = node.combine(1.0, steps, -2.0 * n, turns);
    const Register upright = node.apply(ValueOp::at_least, {k}, {n});
    const Register left = difference(node, i, k);
    const Register low = node.linear(1.0, node.combine(1.0, j, 1.0, k), 1.0 - 2.0 * n);
    Tile tile;
    tile.cell = {node.lerp(upright, left, i), node.lerp(upright, j, low)};
    const Register along = node.lerp(upright, difference(node, x, left), difference(node, y, low));
    tile.u = node.linear(1.0 / n, along);
    tile.v = node.lerp(upright, difference(node, y, j), difference(node, x, i));
    tile.edge = smaller(node, within(node, tile.u, n * width), within(node, tile.v, width));
    const double share = share_of(node, width) * share_of(node, n * width);
    tile.shown = between_joints(node, tile.edge, share, width);
    return given(node, tile);
}

Outputs cells(NodeOps& node) {
    const CellPoints points{seed_of(node), node.parameter("jitter")};
    return node.blend(
        node.apply(CellFeature{points, CellGives(int(node.parameter("gives")))}, node.point()));
}

Outputs scatter(NodeOps& node) {
    ScatteredShapes shapes;
    shapes.seed = seed_of(node);
    shapes.form = ShapeForm(int(node.parameter("shape")));
    shapes.radius = node.parameter("smallest");
    shapes.spread = std::max(node.parameter("largest") - shapes.radius, 0.0);
    shapes.turn = 2.0 * std::numbers::pi * node.parameter("turn");
    shapes.jitter = node.parameter("jitter");
    shapes.chance = node.parameter("chance");
    shapes.gives = ShapeGives(int(node.parameter("gives")));
    const Register result = node.apply(shapes, {node.axis(0), node.axis(1)});
    if (shapes.gives != ShapeGives::cover) return node.blend(result);
    const double widest = 4.0 * (shapes.radius + shapes.spread);
    return node.blend(node.apply(BoxStep{1.0, 0.0, 0.0, shapes.mean(), widest}, {result}));
}

constexpr Parameter gives_parameter =
    one_of("gives", "\"tile\"", "tile|edge|id|u|v",
           "1 on a tile and 0 in joints, the distance to its border (negative in joints), a random "
           "number in [0,1) of the tile, or a coordinate in it");
constexpr Parameter lattice_seed =
    whole("seed", 0, 4294967295.0, "0", "number of the random lattice");
constexpr Parameter joint_parameter(std::string_view otherwise) {
    return real("joint", 0, 1e6, otherwise, "width of the joints between tiles");
}
constexpr Parameter size(std::string_view key, std::string_view otherwise, std::string_view tip) {
    return real(key, 1e-6, 1e6, otherwise, tip);
}
constexpr Parameter width_parameter(std::string_view otherwise) {
    return size("width", otherwise,
                "length along the first coordinate, half of a joint at each end");
}
constexpr Parameter height_parameter(std::string_view otherwise) {
    return size("height", otherwise, "of a course: along the second coordinate");
}
constexpr Parameter depth_parameter =
    real("depth", 0, 1e6, "0", "length along the third coordinate; 0: without end");

constexpr std::array tile_rows{
    a_node("tiles", NodeResult::inputs, squares, "rectangles or boxes side by side", own, two_sides,
           {gives_parameter, width_parameter("1"), height_parameter("1"), depth_parameter,
            joint_parameter("0.05"), lattice_seed}),
    a_node("bricks", NodeResult::inputs, bricks,
           "courses of rectangles or boxes, each moved against the one below", own, two_sides,
           {gives_parameter, width_parameter("1"), height_parameter("0.4"), depth_parameter,
            joint_parameter("0.05"),
            real("offset", -1, 1, "0.5", "how far a course is moved back, in widths and depths"),
            lattice_seed}),
    a_node("planks", NodeResult::inputs, planks,
           "courses of rectangles or boxes, each moved by a random length", own, two_sides,
           {gives_parameter, width_parameter("4"), height_parameter("0.5"), depth_parameter,
            joint_parameter("0.02"), lattice_seed}),
    a_node("hexagons", NodeResult::inputs, hexagons, "regular hexagons, two sides upright", own,
           two_sides,
           {gives_parameter, size("width", "1", "distance of opposite sides, with a joint"),
            joint_parameter("0.05"), lattice_seed}),
    a_node("herringbone", NodeResult::inputs, herringbone,
           "rectangles along the first two coordinates by turns, each of which ends at the next",
           own, two_sides,
           {gives_parameter, size("width", "0.5", "the shorter side of a tile, with a joint"),
            whole("ratio", 1, 64, "3", "widths in a tile's length"), joint_parameter("0.04"),
            lattice_seed}),
    a_node(
        "cells", NodeResult::inputs, cells,
        "the parts of space nearest to random points, one of which lies in every unit cube",
        "Worley 1996", two_sides,
        {one_of("gives", "\"distance\"", "distance|edge|id",
                "the distance to the cell's point, that to the cell's border, or a random number "
                "in [0,1) of the cell"),
         real("jitter", 0, 1, "1", "side of the cube about the middle that holds the point"),
         lattice_seed}),
    a_node("scatter", NodeResult::inputs, scatter,
           "a shape in every unit square, moved about and turned; shapes may overlap", own,
           two_sides,
           {one_of("shape", "\"disk\"", "disk|square|ring|star|leaf", "the form"),
            one_of("gives", "\"shape\"", "shape|edge|id",
                   "1 on shapes, the distance to the top shape's border (negative outside), or a "
                   "random number in [0,1) of the top shape"),
            real("smallest", 0.01, 0.75, "0.2", "least radius of the circle round a shape"),
            real("largest", 0.01, 0.75, "0.45", "largest radius; at or below smallest: smallest"),
            real("turn", 0, 1, "1", "random turns, up to which share of a full one"),
            real("jitter", 0, 1, "1", "side of the square about the middle that holds its middle"),
            real("chance", 0, 1, "1", "share of squares with a shape"), lattice_seed}),
};

}  // namespace

std::span<const NodeType> tiles() {
    return tile_rows;
}

}  // namespace burl::nodes
