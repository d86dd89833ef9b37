#include "app/recipe/lattice_check.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "app/base/mapped_box.h"
#include "atlas/base/error.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/graph/graph.h"
#include "procedural/graph/masks.h"
#include "procedural/graph/table.h"
#include "procedural/model/octaves.h"
#include "procedural/noise/fractal_sum.h"

namespace burl {

namespace {

/// The largest lattice coordinate of a texture's noise, in cells from the origin, with its noise
/// term and octave; the search ends at the first beyond farthest_cell.
struct LatticeReach {
    double reach = 0.0;  ///< infinite where a coordinate is not finite
    std::size_t term = 0;
    std::uint32_t octave = 0;
};

/// The largest absolute lattice coordinate where absolute texture coordinates are at most `sizes`;
/// infinite where it is not a number.
double farthest(const Octave& octave, const Vec3d& sizes) {
    double result = 0.0;
    for (int row = 0; row < 3; ++row) {
        double sum = std::abs(octave.lattice_from_solid.offset[row]);
        for (int column = 0; column < 3; ++column)
            sum += std::abs(octave.lattice_from_solid.linear[column][row]) * sizes[column];
        if (std::isnan(sum)) return HUGE_VAL;
        result = std::max(result, sum);
    }
    return result;
}

/// The reach of the texture's noise where absolute texture coordinates are at most `sizes`. Octaves
/// of amplitude 0 do not count.
LatticeReach farthest_lattice(const Texture& texture, const Vec3d& sizes) {
    LatticeReach result;
    for (std::size_t i = 0; i < texture.noise.size(); ++i) {
        Texture one;
        one.noise = {texture.noise[i]};
        for (const Octave& octave : expand_octaves(one)) {
            const double far = farthest(octave, sizes);
            if (!(far > result.reach)) continue;
            result = {far, i, octave.noise.seed - one.noise[0].seed};
            if (far > farthest_cell) return result;
        }
    }
    return result;
}

/// The end of a sentence about a noise that reaches so many cells from the origin: the problem and
/// its remedies.
std::string too_far(double cells) {
    return fmt::format(
        "reaches {:.2g} lattice cells from the origin, and beyond 2^46 (7e13) cells too little of "
        "a place within its cell is left; use fewer octaves, a smaller lacunarity or frequency, or "
        "a smaller solid.scale",
        cells);
}

double largest(const Vec3d& sizes) {
    const double most = std::max({sizes.x, sizes.y, sizes.z});
    return std::isnan(sizes.x + sizes.y + sizes.z) ? HUGE_VAL : most;
}

/// Bounds of the absolute coordinates of matrix (translate + rotate scale p), given those of p. A
/// rotation is bounded by the distance from the origin.
Vec3d transformed(const NodeParameters& node, const Vec3d& p) {
    const Vec3d scale = glm::abs(node.vector("scale")), shift = glm::abs(node.vector("translate"));
    const bool turned = node.vector("rotate") != Vec3d(0.0);
    Vec3d inner = scale * p;
    if (turned) inner = Vec3d(glm::length(inner));
    inner += shift;
    Vec3d outer(0.0);
    for (int row = 0; row < 3; ++row) {
        const auto entry = [&](int column) {
            return std::abs(node.parameter("matrix", std::size_t(4 * row + column)));
        };
        outer[row] = entry(0) * inner.x + entry(1) * inner.y + entry(2) * inner.z + entry(3);
    }
    return outer;
}

double octave_weights_of(const NodeParameters& node) {
    return octave_weights(node.parameter("gain"), std::uint32_t(node.parameter("octaves")));
}

/// The farthest that a node `curl` moves a coordinate: no component of its field exceeds 3.
Vec3d curl_reach(const NodeParameters& node) {
    return Vec3d(3.0 * std::abs(node.parameter("strength")) * octave_weights_of(node));
}

/// The frequency of a noise node's last octave, or of its first where that is higher.
double highest_frequency(const NodeParameters& node) {
    const double last = std::pow(node.parameter("lacunarity"), node.parameter("octaves") - 1.0);
    return std::max(last, 1.0);
}

/// Bounds of the absolute coordinates of the point that a node makes of a point bounded by p.
Vec3d moved_sizes(const NodeParameters& node, const Vec3d& p) {
    const std::string_view type = type_of(node.self()).name;
    const double distance = glm::length(p);
    if (type == "transform") return transformed(node, p);
    if (type == "warp")  // no noise of three or four dimensions exceeds 2
        return p + Vec3d(2.0 * std::abs(node.parameter("strength")) * octave_weights_of(node));
    if (type == "curl") return p + curl_reach(node);
    if (type == "map_uv")
        return {std::abs(node.parameter("scale", 0)) * p.x + std::abs(node.parameter("offset", 0)),
                std::abs(node.parameter("scale", 1)) * p.y + std::abs(node.parameter("offset", 1)),
                p.z};
    if (type == "map_spherical") return {1.0, 1.0, distance};
    if (type == "map_cylindrical") return {1.0, std::max(p.z, 1.0), distance};
    if (type == "map_planar")
        return {glm::dot(glm::abs(node.vector("vs")), p) + std::abs(node.parameter("offset", 0)),
                glm::dot(glm::abs(node.vector("vt")), p) + std::abs(node.parameter("offset", 1)),
                0.0};
    if (type == "mesh_uv") return {farthest_uv, farthest_uv, 0.0};
    return p;
}

/// The largest absolute number of a tile in a pattern, along any axis.
double tile_reach(const NodeParameters& node, const Vec3d& p) {
    const double width = node.parameter("width"), height = node.parameter("height"),
                 depth = node.parameter("depth");
    if (!(height > 0.0)) return largest({2.0 * p.x / width, 2.0 * p.y / width, 0.0});
    const double course = p.y / height;
    const double moved = std::abs(node.parameter("offset")) * course + 1.0;
    return largest({p.x / width + moved, course, depth > 0.0 ? p.z / depth + moved : 0.0});
}

/// The largest absolute lattice coordinate at which a noise node or pattern is evaluated, in cells,
/// over all octaves; 0 for other nodes.
double reach(const TextureGraph& graph, const NodeParameters& node, const Vec3d& p) {
    const std::string_view type = type_of(node.self()).name;
    if (type == "field") return farthest_lattice(graph.textures[node.self().texture], p).reach;
    if (type == "tiles" || type == "bricks" || type == "planks" || type == "hexagons" ||
        type == "herringbone")
        return tile_reach(node, p);
    if (type == "cells") return largest(p);
    if (type == "dots" || type == "scatter") return largest({p.x, p.y, 0.0});
    if (type == "bumps") return largest(glm::abs(node.vector("frequency")) * p);
    if (type == "curl")  // sampled along the whole walk
        return node.parameter("scale") * highest_frequency(node) * largest(p + curl_reach(node));
    if (type == "fibre") {
        const double size = std::min(node.parameter("length"), node.parameter("width"));
        const double stray = 2.0 * std::abs(node.parameter("wave"));
        return highest_frequency(node) * (glm::length(p) + stray) / size;
    }
    if (type != "simplex_nd" && type != "fbm" && type != "wrinkled" && type != "windy" &&
        type != "marble" && type != "warp")
        return 0.0;
    const double scale = type == "marble" ? node.parameter("scale") : 1.0;
    return scale * highest_frequency(node) * largest(p);
}

/// Throws Error(unsupported) in one sentence, which begins with `name` and names the node, where a
/// noise node may have lattice coordinates beyond farthest_cell, or not finite ones, anywhere in a
/// box of texture coordinates whose absolute values are at most `box_sizes`. Nested mappings are
/// bounded by interval arithmetic, so the bounds may be wider than the coordinates that occur.
void check_graph_lattice(const TextureGraph& graph, const Vec3d& box_sizes,
                         const std::string& name) {
    // Bounds of the points that nodes give; unused for other nodes.
    std::vector<Vec3d> sizes{box_sizes};
    for (std::size_t n = 1; n < graph.nodes.size(); ++n) {
        const NodeParameters node(graph.nodes[n]);
        const Vec3d& p = sizes[node.self().place];
        const double far = reach(graph, node, p);
        if (!(far <= farthest_cell))
            throw Error(
                ExitCode::unsupported,
                fmt::format("{}: a node \"{}\" {}", name, type_of(node.self()).name, too_far(far)));
        sizes.push_back(node.self().wire == Wire::point ? moved_sizes(node, p) : Vec3d(0.0));
    }
}

}  // namespace

void check_lattice(const Recipe& recipe, const Box3& box) {
    const Vec3d sizes = glm::max(glm::abs(box.low), glm::abs(box.high));
    const Texture* texture = plain_texture(recipe.texture);
    if (!texture) check_graph_lattice(recipe.texture, sizes, "texture");
    check_graph_lattice(recipe.bump.input, sizes, "bump.input");
    if (!texture) return;
    const LatticeReach far = farthest_lattice(*texture, sizes);
    if (far.reach <= farthest_cell) return;
    throw Error(ExitCode::unsupported,
                fmt::format("texture.input.noise.{}: octave {} of {} {}", far.term, far.octave + 1,
                            texture->noise[far.term].octaves, too_far(far.reach)));
}

void check_lattice(const Recipe& recipe, const Mesh& mesh) {
    check_lattice(recipe, mapped(texture_from_mesh(recipe, mesh), bounding_box(mesh)));
}

}  // namespace burl
