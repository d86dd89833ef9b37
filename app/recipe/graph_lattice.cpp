#include "app/recipe/graph_lattice.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/recipe/lattice_check.h"
#include "atlas/base/error.h"
#include "procedural/graph/table.h"
#include "procedural/noise/fractal_sum.h"

namespace burl {

namespace {

double largest(const Vec3d& sizes) {
    const double most = std::max({sizes.x, sizes.y, sizes.z});
    return std::isnan(sizes.x + sizes.y + sizes.z) ? HUGE_VAL : most;
}

NodeCall call_of(const GraphNode& node) {
    NodeCall call;
    call.node = &node;
    return call;
}

/// Bounds of the absolute coordinates of matrix (translate + rotate scale p), given those of p. A
/// rotation is bounded by the distance from the origin.
Vec3d transformed(const NodeCall& call, const Vec3d& p) {
    const Vec3d scale = glm::abs(call.vector("scale")), shift = glm::abs(call.vector("translate"));
    const bool turned = call.vector("rotate") != Vec3d(0.0);
    Vec3d inner = scale * p;
    if (turned) inner = Vec3d(glm::length(inner));
    inner += shift;
    Vec3d outer(0.0);
    for (int row = 0; row < 3; ++row) {
        const auto entry = [&](int column) {
            return std::abs(call.parameter("matrix", std::size_t(4 * row + column)));
        };
        outer[row] = entry(0) * inner.x + entry(1) * inner.y + entry(2) * inner.z + entry(3);
    }
    return outer;
}

double octave_weights_of(const NodeCall& call) {
    return octave_weights(call.parameter("gain"), std::uint32_t(call.parameter("octaves")));
}

/// Bounds of the absolute coordinates of the point that a node makes of a point bounded by p.
Vec3d moved_sizes(const NodeCall& call, const Vec3d& p) {
    const std::string_view type = type_of(*call.node).name;
    const double distance = glm::length(p);
    if (type == "transform") return transformed(call, p);
    if (type == "warp")  // no noise of three or four dimensions exceeds 2
        return p + Vec3d(2.0 * std::abs(call.parameter("strength")) * octave_weights_of(call));
    if (type == "map_uv")
        return {std::abs(call.parameter("scale", 0)) * p.x + std::abs(call.parameter("offset", 0)),
                std::abs(call.parameter("scale", 1)) * p.y + std::abs(call.parameter("offset", 1)),
                p.z};
    if (type == "map_spherical") return {1.0, 1.0, distance};
    if (type == "map_cylindrical") return {1.0, std::max(p.z, 1.0), distance};
    if (type == "map_planar")
        return {glm::dot(glm::abs(call.vector("vs")), p) + std::abs(call.parameter("offset", 0)),
                glm::dot(glm::abs(call.vector("vt")), p) + std::abs(call.parameter("offset", 1)),
                0.0};
    return p;
}

/// The largest absolute lattice coordinate at which a noise node is evaluated, in cells, over all
/// octaves; 0 for other nodes.
double reach(const TextureGraph& graph, const NodeCall& call, const Vec3d& p) {
    const std::string_view type = type_of(*call.node).name;
    if (type == "field") return farthest_lattice(graph.textures[call.node->texture], p).reach;
    if (type == "dots") return largest({p.x, p.y, 0.0});
    if (type == "bumps") return largest(glm::abs(call.vector("frequency")) * p);
    if (type != "fbm" && type != "wrinkled" && type != "windy" && type != "marble" &&
        type != "warp")
        return 0.0;
    const double scale = type == "marble" ? call.parameter("scale") : 1.0;
    const double last = std::pow(call.parameter("lacunarity"), call.parameter("octaves") - 1.0);
    return scale * std::max(last, 1.0) * largest(p);
}

}  // namespace

void check_graph_lattice(const TextureGraph& graph, const Vec3d& box_sizes,
                         const std::string& name) {
    // Bounds of the points that nodes give; unused for other nodes.
    std::vector<Vec3d> sizes{box_sizes};
    for (std::size_t n = 1; n < graph.nodes.size(); ++n) {
        const NodeCall call = call_of(graph.nodes[n]);
        const Vec3d& p = sizes[call.node->place];
        const double far = reach(graph, call, p);
        if (!(far <= farthest_cell))
            throw Error(ExitCode::unsupported, fmt::format("{}: a node \"{}\" {}", name,
                                                           type_of(*call.node).name, too_far(far)));
        sizes.push_back(call.node->wire == Wire::point ? moved_sizes(call, p) : Vec3d(0.0));
    }
}

}  // namespace burl
