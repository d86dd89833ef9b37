#include "app/measure/evaluate_points.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "app/recipe/lattice_check.h"
#include "atlas/base/error.h"
#include "procedural/color/table.h"
#include "procedural/fixed/field.h"
#include "procedural/graph/evaluator.h"
#include "procedural/model/octaves.h"

namespace burl {

namespace {

template <class Real, std::size_t N>
Evaluation evaluate_at(const NoiseOptions& noise, const std::array<double, 4>& point) {
    Point<N> p;
    std::copy_n(point.begin(), N, p.begin());
    const NoiseSample<Real, N> n = sample_noise<Real>(noise, p);
    return {double(n.value), {n.gradient.begin(), n.gradient.end()}, {}};
}

template <std::size_t N>
std::vector<PointResult> evaluate_all(const NoiseOptions& noise, const PointFile& file) {
    std::vector<PointResult> results;
    for (const auto& point : file.points)
        results.push_back(
            {evaluate_at<double, N>(noise, point), evaluate_at<float, N>(noise, point)});
    return results;
}

std::vector<PointResult> evaluate_all(const NoiseOptions& noise, const PointFile& file) {
    switch (file.dimensions) {
        case 1:
            return evaluate_all<1>(noise, file);
        case 2:
            return evaluate_all<2>(noise, file);
        case 3:
            return evaluate_all<3>(noise, file);
        default:
            return evaluate_all<4>(noise, file);
    }
}

/// The sum of octaves as the noise of a texture.
Texture texture_of(const NoiseOptions& options) {
    NoiseTerm term;
    term.kind = options.noise.kind, term.fade = options.noise.fade, term.seed = options.noise.seed;
    term.shape = options.fractal.shape, term.normalized = options.fractal.normalized;
    term.octaves = options.fractal.octaves, term.gain = options.fractal.gain;
    term.lacunarity = options.fractal.lacunarity;
    term.range = term.shape == OctaveShape::plain ? NoiseRange::bipolar : NoiseRange::unit;
    Texture texture;
    texture.noise = {term};
    return texture;
}

/// A recipe prepared for many points.
struct PreparedRecipe {
    Quadric quadric;
    std::vector<Octave> octaves;
    PreparedColorMap colors;
    Affine3 map;
};

template <class Real>
Evaluation evaluate_at(const PreparedRecipe& recipe, const Vec3d& point) {
    const FieldSample f = sample_field<Real>(recipe.quadric, recipe.octaves, recipe.map(point));
    const Vec3d gradient = f.gradient * recipe.map.linear, color = recipe.colors(f.value);
    const auto rounded = [](double x) { return double(Real(x)); };
    return {rounded(f.value),
            {rounded(gradient.x), rounded(gradient.y), rounded(gradient.z)},
            Vec3d(rounded(color.x), rounded(color.y), rounded(color.z))};
}

Evaluation evaluate_fixed(const PreparedRecipe& recipe, const FixedField& field,
                          const Vec3d& point) {
    const double f = field(recipe.map(point));
    return {f, {}, recipe.colors(f)};
}

/// Evaluates a graph at a point; the value of a colour is its luminance (ITU-R BT.709).
template <class Real>
Evaluation evaluate_graph(const GraphEvaluator& evaluate, GraphEvaluator::Scratch& scratch,
                          const Affine3& map, const Vec3d& point) {
    const Vec3d s = map(point);
    GraphSample sample;
    evaluate({&s, 1}, {}, scratch, {&sample, 1});
    const auto& c = sample.channels;
    const Dual value =
        sample.wire == Wire::number ? c[0] : 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    const Vec3d gradient = value.slope * map.linear, color = sample.color();
    const auto rounded = [](double x) { return double(Real(x)); };
    return {rounded(value.value),
            {rounded(gradient.x), rounded(gradient.y), rounded(gradient.z)},
            Vec3d(rounded(color.x), rounded(color.y), rounded(color.z))};
}

std::vector<PointResult> evaluate_graph(const Recipe& recipe, const PointFile& file) {
    const Filter filter{FilterKind::trapezoid};
    const GraphEvaluator exact(recipe.texture, filter),
        quick(recipe.texture, filter, PrecisionKind::float32);
    GraphEvaluator::Scratch scratch = exact.make_scratch();
    const Affine3 map = texture_from_solid(recipe);
    std::vector<PointResult> results;
    for (const auto& [x, y, z, w] : file.points) {
        const Vec3d point(x, y, z);
        results.push_back({evaluate_graph<double>(exact, scratch, map, point),
                           evaluate_graph<float>(quick, scratch, map, point)});
    }
    return results;
}

/// The values of a recipe of which `texture` is the plain texture.
std::vector<PointResult> evaluate_model(const Recipe& recipe, const Texture& texture,
                                        const PointFile& file) {
    const PreparedRecipe prepared{texture.quadric, expand_octaves(texture),
                                  PreparedColorMap(texture.colors), texture_from_solid(recipe)};
    std::optional<FixedField> fixed;
    if (recipe.precision.kind == PrecisionKind::fixed)
        fixed.emplace(texture, recipe.precision.format);
    std::vector<PointResult> results;
    for (const auto& [x, y, z, w] : file.points) {
        const Vec3d point(x, y, z);
        results.push_back(
            {evaluate_at<double>(prepared, point), fixed ? evaluate_fixed(prepared, *fixed, point)
                                                         : evaluate_at<float>(prepared, point)});
    }
    return results;
}

/// Throws Error(unsupported) where an octave has lattice coordinates beyond farthest_cell.
void check_reach(const NoiseOptions& noise, const PointFile& file) {
    const double finest =
        std::pow(std::max(noise.fractal.lacunarity, 1.0), double(noise.fractal.octaves) - 1.0);
    for (std::size_t i = 0; i < file.points.size(); ++i)
        for (const double x : file.points[i]) {
            const double reach = finest * (std::abs(x) + std::abs(noise.warp));
            if (reach <= farthest_cell) continue;
            throw Error(
                ExitCode::unsupported,
                fmt::format("point {}: the noise reaches {:.2g} lattice cells from the origin, and "
                            "beyond 2^46 (7e13) cells too little of a place within its cell is "
                            "left; use points nearer to the origin, fewer octaves or a smaller "
                            "lacunarity",
                            i + 1, reach));
        }
}

/// The results without the other precision, which would be float64 again.
std::vector<PointResult> only_float64(std::vector<PointResult> results) {
    for (PointResult& result : results) result.other.reset();
    return results;
}

}  // namespace

std::vector<PointResult> evaluate_points(NoiseOptions noise, const PointFile& file,
                                         const Precision& precision) {
    noise.resolve(file.dimensions);
    check_reach(noise, file);
    std::vector<PointResult> results = evaluate_all(noise, file);
    if (precision.kind == PrecisionKind::float64) return only_float64(std::move(results));
    if (precision.kind != PrecisionKind::fixed) return results;
    if (file.dimensions != 3 || noise.warp != 0.0 || !has_fixed_point(noise.noise))
        throw Error(ExitCode::usage,
                    "--precision fixed is for value and perlin noise in 3 dimensions, without "
                    "period or warp");
    const FixedField field(texture_of(noise), precision.format);
    for (std::size_t i = 0; i < results.size(); ++i) {
        const auto& [x, y, z, w] = file.points[i];
        results[i].other = Evaluation{field({x, y, z}), {}, {}};
    }
    return results;
}

std::vector<PointResult> evaluate_points(const Recipe& recipe, const PointFile& file) {
    if (file.dimensions != 3)
        throw Error(
            ExitCode::usage,
            fmt::format("a recipe needs points x,y,z; these have {} coordinates", file.dimensions));
    for (const auto& [x, y, z, w] : file.points) {
        const Vec3d s = texture_from_solid(recipe)(Vec3d(x, y, z));
        check_lattice(recipe, Box3{s, s});
    }
    const Texture* texture = plain_texture(recipe.texture);
    std::vector<PointResult> results =
        texture ? evaluate_model(recipe, *texture, file) : evaluate_graph(recipe, file);
    if (recipe.precision.kind == PrecisionKind::float64) return only_float64(std::move(results));
    return results;
}

}  // namespace burl
