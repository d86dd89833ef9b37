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
    if (!texture)
        return "the texture has other nodes than a color_map over a field, or transparent stops";
    if (std::string why = no_forward_form(expand_octaves(*texture)); !why.empty()) return why;
    if (recipe.filter.kind != FilterKind::none || recipe.filter.band_limit)
        return "filters need f besides the scan line, and differences run along it";
    if (recipe.precision.kind.value_or(PrecisionKind::float64) == PrecisionKind::fixed)
        return "it adds in float64 or float32, not in fixed:I.F";
    return "";
}

}  // namespace

bool has_fast_way(const Recipe& recipe, const HostWay& way) {
    return !way.forward && bake_precision(recipe) == PrecisionKind::float32;
}

template <class Pixel>
Image<Pixel> fill_unpainted(const SolidAtlas& solid, const Recipe& recipe, const HostWay& way,
                            const Economy& economy, const RowWindow& rows,
                            const MaskImages& masks) {
    const Affine3 map = texture_from_solid(recipe);
    const Texture* texture = plain_texture(recipe.texture);
    if (!texture)  // one function for both precisions
        return synthesize_graph<Pixel>(solid, recipe.texture, map, recipe.filter, way.threads,
                                       bake_precision(recipe), economy, rows, masks);
    if (way.forward)
        return synthesize_forward<Pixel>(solid, *texture, map, forward_precision(recipe),
                                         way.threads, economy, rows);
    if (!has_fast_way(recipe, way))
        return synthesize_texels<Pixel>(solid, *texture, map, recipe.precision, recipe.filter,
                                        way.threads, economy, rows);
    return synthesize_model<Pixel>(solid, *texture, map, way.threads, recipe.filter, way.kernel,
                                   economy, rows);
}

template <class Pixel>
Image<Pixel> fill_texture(const SolidAtlas& solid, const Recipe& recipe, const HostWay& way,
                          const Economy& economy, const MaskImages& masks) {
    auto image = fill_unpainted<Pixel>(solid, recipe, way, economy, {}, masks);
    paint_over(solid, recipe.paint, way.threads, image);
    return image;
}

void fill_in_bands(const SolidAtlas& solid, const Recipe& recipe, const HostWay& way,
                   const Economy& economy, const MaskImages& masks, std::size_t texels,
                   const TakeRows& take) {
    const std::size_t least = band_rows * solid.size;
    const std::size_t at_once = band_rows * std::max<std::size_t>(1, texels / least);
    const Texture* texture = plain_texture(recipe.texture);
    if (texture && has_fast_way(recipe, way))
        return synthesize_model_in_bands(solid, *texture, texture_from_solid(recipe), way.threads,
                                         recipe.filter, way.kernel, economy, at_once, take);
    for (std::size_t first = 0; first < solid.size; first += at_once)
        take(first,
             fill_unpainted<RgbF>(solid, recipe, way, economy, {first, first + at_once}, masks));
}

template Image<Rgb8> fill_texture(const SolidAtlas&, const Recipe&, const HostWay&, const Economy&,
                                  const MaskImages&);
template Image<Rgb16> fill_texture(const SolidAtlas&, const Recipe&, const HostWay&, const Economy&,
                                   const MaskImages&);
template Image<RgbF> fill_texture(const SolidAtlas&, const Recipe&, const HostWay&, const Economy&,
                                  const MaskImages&);
template Image<Rgb8> fill_unpainted(const SolidAtlas&, const Recipe&, const HostWay&,
                                    const Economy&, const RowWindow&, const MaskImages&);
template Image<Rgb16> fill_unpainted(const SolidAtlas&, const Recipe&, const HostWay&,
                                     const Economy&, const RowWindow&, const MaskImages&);
template Image<RgbF> fill_unpainted(const SolidAtlas&, const Recipe&, const HostWay&,
                                    const Economy&, const RowWindow&, const MaskImages&);

void check_forward(const Recipe& recipe) {
    if (const std::string problem = forward_problem(recipe); !problem.empty())
        throw Error(ExitCode::usage, fmt::format("--kernel forward: {}; leave it out", problem));
}

}  // namespace burl
