#include "app/evaluate_points.h"

#include <algorithm>
#include <span>

#include "atlas/error.h"
#include "procedural/color_table.h"
#include "procedural/graph_evaluator.h"
#include "procedural/octaves.h"

namespace burl {

namespace {

[[noreturn]] void refuse_fixed_point() {
    throw Error(ExitCode::usage,
                "--fixed is for value and perlin noise in 3 dimensions, without period or warp");
}

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
            {evaluate_at<double, N>(noise, point), evaluate_at<float, N>(noise, point), {}});
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

/// The sum of octaves with their noise in fixed point.
double fixed_sum(const NoiseOptions& options, const FixedFormat& format, const Point<3>& p) {
    return fractal_sum<double>(
               options.fractal, p,
               [&](std::uint32_t k, const Point<3>& q) {
                   NoiseSpec octave = options.noise;
                   octave.seed += k;
                   const Vec3d place(q[0], q[1], q[2]);
                   return NoiseSample<double, 3>{fixed_noise(octave, format, place), {}};
               })
        .value;
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

Evaluation evaluate_fixed(const PreparedRecipe& recipe, const FixedFormat& format,
                          const Vec3d& point) {
    const Vec3d s = recipe.map(point);
    double f = evaluate_quadric(recipe.quadric, s);
    for (const Octave& octave : recipe.octaves) {
        const double n = fixed_noise(octave.noise, format, octave.lattice_from_solid(s));
        f += octave.offset + octave.scale * shaped(octave.shape, n);
    }
    return {f, {}, recipe.colors(f)};
}

/// A graph is evaluated in float64 alone, and its result rounded. A colour's value is its luminance
/// (ITU-R BT.709).
PointResult evaluate_graph(const GraphEvaluator& evaluate, GraphEvaluator::Scratch& scratch,
                           const Affine3& map, const Vec3d& point) {
    const Vec3d s = map(point);
    GraphSample sample;
    evaluate({&s, 1}, {}, scratch, {&sample, 1});
    const auto& c = sample.channels;
    const Dual value =
        sample.wire == Wire::number ? c[0] : 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    const Vec3d gradient = value.slope * map.linear, color = sample.color();
    const auto as = [&](auto rounded) -> Evaluation {
        return {rounded(value.value),
                {rounded(gradient.x), rounded(gradient.y), rounded(gradient.z)},
                Vec3d(rounded(color.x), rounded(color.y), rounded(color.z))};
    };
    return {as([](double x) { return x; }), as([](double x) { return double(float(x)); }), {}};
}

std::vector<PointResult> evaluate_graph(const Recipe& recipe, const PointFile& file) {
    const GraphEvaluator evaluate(recipe.graph);
    GraphEvaluator::Scratch scratch = evaluate.make_scratch();
    std::vector<PointResult> results;
    for (const auto& [x, y, z, w] : file.points)
        results.push_back(evaluate_graph(evaluate, scratch, texture_from_solid(recipe), {x, y, z}));
    return results;
}

}  // namespace

std::vector<PointResult> evaluate_points(NoiseOptions noise, const PointFile& file,
                                         const std::optional<FixedFormat>& format) {
    noise.resolve(file.dimensions);
    if (format && (file.dimensions != 3 || noise.warp != 0.0 || !has_fixed_point(noise.noise)))
        refuse_fixed_point();
    std::vector<PointResult> results = evaluate_all(noise, file);
    for (std::size_t i = 0; format && i < results.size(); ++i) {
        const auto& [x, y, z, w] = file.points[i];
        results[i].fixed = Evaluation{fixed_sum(noise, *format, {x, y, z}), {}, {}};
    }
    return results;
}

std::vector<PointResult> evaluate_points(const Recipe& recipe, const PointFile& file,
                                         const std::optional<FixedFormat>& format) {
    if (file.dimensions != 3)
        throw Error(
            ExitCode::usage,
            fmt::format("a recipe needs points x,y,z; these have {} coordinates", file.dimensions));
    if (!recipe.graph.empty() && format) refuse_fixed_point();
    if (!recipe.graph.empty()) return evaluate_graph(recipe, file);
    const PreparedRecipe prepared{recipe.texture.quadric, expand_octaves(recipe.texture),
                                  PreparedColorMap(recipe.texture.colors),
                                  texture_from_solid(recipe)};
    const auto has_none = [](const Octave& octave) { return !has_fixed_point(octave.noise); };
    if (format && std::any_of(prepared.octaves.begin(), prepared.octaves.end(), has_none))
        refuse_fixed_point();
    std::vector<PointResult> results;
    for (const auto& [x, y, z, w] : file.points) {
        const Vec3d point(x, y, z);
        results.push_back(
            {evaluate_at<double>(prepared, point), evaluate_at<float>(prepared, point), {}});
        if (format) results.back().fixed = evaluate_fixed(prepared, *format, point);
    }
    return results;
}

}  // namespace burl
