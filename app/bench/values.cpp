#include "app/bench/values.h"

#include "procedural/color/srgb.h"
#include "procedural/color/table.h"
#include "procedural/graph/evaluator.h"
#include "procedural/model/octaves.h"

namespace burl {

namespace {

using Values = std::vector<double>;

template <class Visit>
void for_each_texel(const SolidAtlas& solid, std::uint32_t step, const Visit& visit) {
    for (std::uint32_t y = 0; y < solid.size; y += step)
        for (const Span& span : solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
                visit(solid.maps[span.map], x, y);
}

void append(const Vec3d& color, Values& values) {
    values.insert(values.end(), {color.x, color.y, color.z});
}

/// Returns the values of a graph in float64.
Values defined_graph(const SolidAtlas& solid, const Recipe& recipe, std::uint32_t step) {
    const GraphEvaluator evaluate(recipe.texture);
    GraphEvaluator::Scratch scratch = evaluate.make_scratch();
    const Affine3 from_solid = texture_from_solid(recipe);
    std::vector<Vec3d> points;
    Values values;
    const auto flush = [&] {
        std::vector<GraphSample> samples(points.size());
        evaluate(points, {}, scratch, samples);
        for (const GraphSample& sample : samples) append(sample.color(), values);
        points.clear();
    };
    for_each_texel(solid, step, [&](const TexelMap& texel, std::uint32_t x, std::uint32_t y) {
        points.push_back(from_solid(texel(x, y)));
        if (points.size() == graph_batch_size) flush();
    });
    flush();
    return values;
}

}  // namespace

std::vector<double> color_values(const SolidAtlas& solid, const Image<Rgb8>& image,
                                 std::uint32_t step) {
    Values values;
    for_each_texel(solid, step, [&](const TexelMap&, std::uint32_t x, std::uint32_t y) {
        append(linear_light(image(x, y)), values);
    });
    return values;
}

std::vector<double> color_values(const SolidAtlas& solid, const Image<RgbF>& image,
                                 std::uint32_t step) {
    Values values;
    for_each_texel(solid, step, [&](const TexelMap&, std::uint32_t x, std::uint32_t y) {
        const RgbF& c = image(x, y);
        append({c.r, c.g, c.b}, values);
    });
    return values;
}

std::vector<double> defined_colors(const SolidAtlas& solid, const Recipe& recipe,
                                   std::uint32_t step) {
    const Texture* texture = plain_texture(recipe.texture);
    if (!texture) return defined_graph(solid, recipe, step);
    const std::vector<Octave> octaves = expand_octaves(*texture);
    const PreparedColorMap map(texture->colors);
    const Affine3 from_solid = texture_from_solid(recipe);
    Values values;
    for_each_texel(solid, step, [&](const TexelMap& texel, std::uint32_t x, std::uint32_t y) {
        append(map(evaluate_field(texture->quadric, octaves, from_solid(texel(x, y)))), values);
    });
    return values;
}

}  // namespace burl
