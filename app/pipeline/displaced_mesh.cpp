#include "app/pipeline/displaced_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/pipeline/mesh_shape.h"
#include "app/surface/normals.h"
#include "atlas/base/each_index.h"
#include "atlas/base/error.h"
#include "procedural/graph/evaluator.h"
#include "procedural/graph/masks.h"

namespace burl {

namespace {

/// A unit normal for every point, or zero where its corners have none.
std::vector<Vec3d> point_normals(const Mesh& mesh) {
    const std::vector<Vec3f> corners = corner_normals(mesh, 180.0);
    std::vector<Vec3d> normals(mesh.positions.size(), Vec3d(0.0));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            normals[mesh.triangles[t][k]] +=
                corner_angle(mesh.positions, mesh.triangles[t], k) * Vec3d(corners[3 * t + k]);
    for (Vec3d& normal : normals) normal = unit_or_zero(normal);
    return normals;
}

/// The masks of the recipe's bump.input at the points of a mesh, whose recipe's solid lies in the
/// box of `rest`.
MaskValues masks_of(const Mesh& mesh, const Recipe& recipe, const Mesh& rest) {
    if (first_mask_node(recipe.bump.input, GraphOutput::color).empty()) return {};
    const Affine3 map = solid_from_mesh(rest, recipe.solid.space);
    return masks_at(MeshShape(mesh, map), recipe, recipe.bump.input, map_positions(mesh, map));
}

/// The values of the recipe's bump.input at points of its texture's space.
std::vector<double> heights_at(const TextureGraph& input, const std::vector<Vec3d>& points,
                               const MaskValues& masks) {
    const GraphEvaluator evaluate(input);
    std::vector<double> heights(points.size());
    const std::size_t batches = (points.size() + graph_batch_size - 1) / graph_batch_size;
    const auto fill = [&](std::size_t batch) {
        const std::size_t first = batch * graph_batch_size;
        const std::size_t count = std::min(graph_batch_size, points.size() - first);
        std::array<GraphSample, graph_batch_size> samples;
        GraphEvaluator::Scratch scratch = evaluate.make_scratch();
        for (const std::vector<Dual>& mask : masks)
            scratch.masks.emplace_back(&mask[first], &mask[first] + count);
        evaluate({&points[first], count}, {}, scratch, {samples.data(), count});
        for (std::size_t i = 0; i < count; ++i) heights[first + i] = samples[i].channels[0].value;
    };
    for_each_index(batches, fill, 16);
    return heights;
}

}  // namespace

Mesh displaced_mesh(const Mesh& mesh, const Recipe& recipe, const Mesh& rest) {
    const Affine3 map = texture_from_mesh(recipe, rest);
    const double height = recipe.bump.height / solid_units(rest, recipe.solid.space);
    std::vector<Vec3d> points;
    for (const Vec3d& p : mesh.positions) points.push_back(map(p));
    const std::vector<double> heights =
        heights_at(recipe.bump.input, points, masks_of(mesh, recipe, rest));
    if (!std::ranges::all_of(heights, [](double h) { return std::isfinite(h); }))
        throw Error(ExitCode::unsupported,
                    "bump.input has no finite value at some of the mesh's points, which "
                    "displacement would move there; clamp it");
    const std::vector<Vec3d> normals = point_normals(mesh);
    Mesh displaced = mesh;
    for (std::size_t i = 0; i < points.size(); ++i)
        displaced.positions[i] += height * heights[i] * normals[i];
    displaced.corners.normals.clear();
    return displaced;
}

}  // namespace burl
