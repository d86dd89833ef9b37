#include "app/measure/metric_texture.h"

#include <algorithm>
#include <array>

#include "app/measure/normal_error.h"
#include "app/pipeline/texture_color.h"
#include "atlas/measure/surface_points.h"
#include "procedural/color/srgb.h"
#include "procedural/model/metric_marble.h"
#include "procedural/model/octaves.h"

namespace burl {

namespace {

constexpr double coarsest_detail = 1.0 / 40;
constexpr double detail_of_cell = 0.4;
constexpr double graph_detail = 1.0 / 200;

double half_diagonal(std::span<const Vec3d> positions) {
    Vec3d low = positions[0], high = positions[0];
    for (const Vec3d& p : positions) low = glm::min(low, p), high = glm::max(high, p);
    return 0.5 * glm::length(high - low);
}

/// The map to the unit box, and the half diagonal of the mesh there.
struct Normalising {
    Affine3 to_unit;  ///< scales the longest side to 1, so that nothing overflows
    double half = 1.0;

    explicit Normalising(const Mesh& mesh) : to_unit(solid_from_mesh(mesh, SolidSpace::unit)) {
        const double length = half_diagonal(map_positions(mesh, to_unit));
        if (length > 0.0) half = length;
    }
};

/// The map from the normalised mesh to texture coordinates.
Affine3 texture_from_normalised(const Recipe& recipe, const Mesh& mesh) {
    const Normalising map(mesh);
    const Affine3 unit_from_normalised{Mat3d(map.half), Vec3d(0.0)};
    if (recipe.solid.space == SolidSpace::unit)
        return texture_from_solid(recipe).after(unit_from_normalised);
    const Mat3d inverse = glm::inverse(map.to_unit.linear);
    const Affine3 mesh_from_unit{inverse, -(inverse * map.to_unit.offset)};
    return texture_from_mesh(recipe, mesh).after(mesh_from_unit.after(unit_from_normalised));
}

/// The detail of noise: a share of the lattice cell that is smallest on the normalised mesh.
double detail_of(std::span<const Octave> octaves, const Affine3& from_normalised) {
    double highest = 0.0;  // steps in the lattice per unit step on the mesh
    for (const Octave& octave : octaves) {
        const Mat3d steps = octave.lattice_from_solid.linear * from_normalised.linear;
        for (int axis = 0; axis < 3; ++axis) highest = std::max(highest, glm::length(steps[axis]));
    }
    return highest > 0.0 ? std::min(coarsest_detail, detail_of_cell / highest) : coarsest_detail;
}

}  // namespace

MetricTexture metric_marble_texture() {
    return {metric_marble_name, grey(metric_marble), coarsest_detail};
}

MetricTexture recipe_texture(const Recipe& recipe, const Mesh& mesh) {
    const Affine3 map = texture_from_normalised(recipe, mesh);
    const Texture* plain = plain_texture(recipe.texture);
    return {recipe.name,
            [map, color = texture_color(recipe)](const Vec3d& point) { return color(map(point)); },
            plain ? detail_of(expand_octaves(*plain), map) : graph_detail};
}

Mesh normalised(const Mesh& mesh) {
    const Normalising map(mesh);
    Mesh result = mesh;
    result.positions = map_positions(mesh, map.to_unit);
    for (Vec3d& p : result.positions) p /= map.half;
    return result;
}

StoredValue in_8bit_srgb() {
    std::array<double, 256> decoded{};
    for (std::size_t code = 0; code < decoded.size(); ++code)
        decoded[code] = srgb_decode(double(code) / 255.0);
    return [encode = SrgbEncoder<std::uint8_t>(), decoded](double linear) {
        return decoded[encode(linear)];
    };
}

SurfaceTruth level_truth(Pipeline& pipeline, std::uint32_t first, std::uint32_t last,
                         std::size_t points) {
    const Mesh& mesh = pipeline.mesh();
    const MetricTexture texture = recipe_texture(pipeline.recipe(), mesh);
    TruthOptions options;
    options.size = pipeline.recipe().atlas.size;
    options.detail = texture.detail;
    options.first_level = first;
    options.levels = last;
    options.level_points = points;
    options.points = options.grazing_points = 0;
    options.grazing_levels = 0;
    SurfaceTruth truth = surface_truth(normalised(mesh), texture.color, options);
    truth.level_points = refined_points(mesh, pipeline.mesh_atlas(), std::move(truth.level_points));
    return truth;
}

std::vector<double> level_errors(const Atlas& atlas, std::span<const Image<RgbF>> levels,
                                 const SurfaceTruth& truth) {
    std::vector<double> errors;
    for (std::size_t l = 0; l < std::min(levels.size(), truth.levels.size()); ++l) {
        const std::vector<Vec3d>& means = truth.levels[l].means;
        errors.push_back(
            means.empty() ? 0.0
                          : lookup_rmse(atlas, components(levels[l]), truth.level_points, means));
    }
    return errors;
}

}  // namespace burl
