#include "app/pipeline/fill_texture.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/paint/texture.h"
#include "atlas/base/error.h"
#include "procedural/bresenham/field.h"
#include "procedural/fill/forward.h"
#include "procedural/fill/graph.h"
#include "procedural/fill/synthesize.h"
#include "procedural/fill/texels.h"

namespace burl {

namespace {

PrecisionKind bake_precision(const Recipe& recipe) {
    return recipe.precision.kind.value_or(PrecisionKind::float32);
}

ForwardPrecision forward_precision(const Recipe& recipe) {
    return recipe.precision.kind == PrecisionKind::float32 ? ForwardPrecision::float32
                                                           : ForwardPrecision::float64;
}

/// The reason why forward differences cannot make the recipe's texture; empty where they can.
std::string forward_problem(const Recipe& recipe) {
    const Texture* texture = plain_texture(recipe.texture);
    if (!texture) return "the texture has other nodes than a color_map over a field";
    if (const std::string why = no_forward_form(expand_octaves(*texture)); !why.empty()) return why;
    if (recipe.filter.kind != FilterKind::none || recipe.filter.band_limit)
        return "filters need f besides the scan line, and differences run along it";
    if (recipe.precision.kind.value_or(PrecisionKind::float64) == PrecisionKind::fixed)
        return "it adds in float64 or float32, not in fixed:I.F";
    return "";
}

/// Table of the synthesis functions for one kind of pixel.
template <class Pixel>
struct Fast;
template <>
struct Fast<Rgb8> {
    static constexpr auto model = synthesize_rgb8;
    static constexpr auto graph = synthesize_graph_rgb8;
};
template <>
struct Fast<Rgb16> {
    static constexpr auto model = synthesize_rgb16;
    static constexpr auto graph = synthesize_graph_rgb16;
};
template <>
struct Fast<RgbF> {
    static constexpr auto model = synthesize_rgbf;
    static Image<RgbF> graph(const SolidAtlas& solid, const TextureGraph& graph, const Affine3& map,
                             const Filter& filter, int threads, PrecisionKind precision,
                             const Economy& economy) {
        return synthesize_graph_rgbf(solid, graph, map, filter, threads, precision, economy);
    }
};

/// The rows `rows` of a texture in linear light; not of a plain one that has_fast_way.
Image<RgbF> rows_by_other_ways(const SolidAtlas& solid, const Recipe& recipe, const HostWay& way,
                               const Economy& economy, const RowWindow& rows) {
    const Affine3 map = texture_from_solid(recipe);
    const Texture* texture = plain_texture(recipe.texture);
    if (!texture)
        return synthesize_graph_rgbf(solid, recipe.texture, map, recipe.filter, way.threads,
                                     bake_precision(recipe), economy, rows);
    if (way.forward)
        return synthesize_forward<RgbF>(solid, *texture, map, forward_precision(recipe),
                                        way.threads, economy, rows);
    return synthesize_texels<RgbF>(solid, *texture, map, recipe.precision, recipe.filter,
                                   way.threads, economy, rows);
}

}  // namespace

bool has_fast_way(const Recipe& recipe, const HostWay& way) {
    return !way.forward && bake_precision(recipe) == PrecisionKind::float32;
}

template <class Pixel>
Image<Pixel> fill_unpainted(const SolidAtlas& solid, const Recipe& recipe, const HostWay& way,
                            const Economy& economy) {
    const Affine3 map = texture_from_solid(recipe);
    const Texture* texture = plain_texture(recipe.texture);
    if (!texture)  // one function for both precisions
        return Fast<Pixel>::graph(solid, recipe.texture, map, recipe.filter, way.threads,
                                  bake_precision(recipe), economy);
    if (way.forward)
        return synthesize_forward<Pixel>(solid, *texture, map, forward_precision(recipe),
                                         way.threads, economy);
    if (!has_fast_way(recipe, way))
        return synthesize_texels<Pixel>(solid, *texture, map, recipe.precision, recipe.filter,
                                        way.threads, economy);
    return Fast<Pixel>::model(solid, *texture, map, way.threads, recipe.filter, way.kernel,
                              economy);
}

template <class Pixel>
Image<Pixel> fill_texture(const SolidAtlas& solid, const Recipe& recipe, const HostWay& way,
                          const Economy& economy) {
    auto image = fill_unpainted<Pixel>(solid, recipe, way, economy);
    paint_over(solid, recipe.paint, way.threads, image);
    return image;
}

void fill_in_bands(const SolidAtlas& solid, const Recipe& recipe, const HostWay& way,
                   const Economy& economy, std::size_t texels, const TakeRows& take) {
    const Texture* texture = plain_texture(recipe.texture);
    if (texture && has_fast_way(recipe, way))
        return synthesize_rgbf_bands(solid, *texture, texture_from_solid(recipe), way.threads,
                                     recipe.filter, way.kernel, economy, texels, take);
    const std::size_t least = band_rows * solid.size;
    const std::size_t at_once = band_rows * std::max<std::size_t>(1, texels / least);
    for (std::size_t first = 0; first < solid.size; first += at_once)
        take(first, rows_by_other_ways(solid, recipe, way, economy, {first, first + at_once}));
}

template Image<Rgb8> fill_texture(const SolidAtlas&, const Recipe&, const HostWay&, const Economy&);
template Image<Rgb16> fill_texture(const SolidAtlas&, const Recipe&, const HostWay&,
                                   const Economy&);
template Image<RgbF> fill_texture(const SolidAtlas&, const Recipe&, const HostWay&, const Economy&);
template Image<Rgb8> fill_unpainted(const SolidAtlas&, const Recipe&, const HostWay&,
                                    const Economy&);
template Image<Rgb16> fill_unpainted(const SolidAtlas&, const Recipe&, const HostWay&,
                                     const Economy&);
template Image<RgbF> fill_unpainted(const SolidAtlas&, const Recipe&, const HostWay&,
                                    const Economy&);

void check_forward(const Recipe& recipe) {
    if (const std::string problem = forward_problem(recipe); !problem.empty())
        throw Error(ExitCode::usage, fmt::format("--kernel forward: {}; leave it out", problem));
}

}  // namespace burl
