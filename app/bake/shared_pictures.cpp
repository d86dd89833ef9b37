#include "app/bake/shared_pictures.h"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "app/paint/texture.h"
#include "app/pipeline/picture_bands.h"
#include "app/pipeline/tasks.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

/// Copies the texels of rows, from row `first` on, that spans show; takes them all where there are
/// none yet.
template <class Pixel>
void place(const SolidAtlas& shown, std::size_t first, Image<Pixel> from, Image<Pixel>& to) {
    if (to.width() == 0) {
        to = std::move(from);
        return;
    }
    for (std::size_t y = 0; y < from.height(); ++y)
        for (const Span& span : shown.row(first + y))
            std::ranges::copy_n(&from(span.x, y), span.count, &to(span.x, y));
}

/// Paints over rows, from row `first` on, of the recipe's colour, which is opaque where it has
/// paint.
template <class Code>
void paint(const SolidAtlas& solid, const Recipe& recipe, int threads, std::size_t first,
           Image<Rgba<Code>>& color) {
    if (!has_color_paint(recipe.paint)) return;
    auto opaque = converted<Rgb<Code>>(color, [](const Rgba<Code>& p) {
        return Rgb<Code>{p.r, p.g, p.b};
    });
    paint_over(solid, recipe.paint, threads, opaque, first);
    const Code full = std::is_floating_point_v<Code> ? Code(1) : std::numeric_limits<Code>::max();
    color = converted<Rgba<Code>>(opaque, [&](const Rgb<Code>& p) {
        return Rgba<Code>{p.r, p.g, p.b, full};
    });
}

Error was_stopped() {
    return Error(ExitCode::runtime, "the bake was stopped before it was done");
}

/// The plans of the base colour and of the pictures.
std::vector<PicturePlan> plans_of(const Recipe& recipe,
                                  const std::vector<MaterialPicture>& pictures) {
    std::vector<PicturePlan> plans{base_color_plan(recipe)};
    for (const MaterialPicture& one : pictures) plans.push_back(one.plan);
    return plans;
}

/// Calls fill(recipe) for each of several recipes, while the pipeline has that and shows its label.
template <class Fill>
void for_each_share(Pipeline& pipeline, std::span<const Recipe> recipes, const Fill& fill) {
    for (std::uint32_t label = 0; label < recipes.size(); ++label) {
        pipeline.set_recipe(recipes[label]);
        pipeline.show_label(label);
        fill(recipes[label]);
    }
    pipeline.show_label({});
    pipeline.set_recipe(recipes.front());
}

/// One of several recipes that share an atlas.
template <class Pixel>
struct Share {
    SolidAtlas solid;                 ///< of its own texels
    std::vector<std::size_t> places;  ///< the number of each of its pictures among all
    PictureBands<Pixel> bands;
};

/// The recipes with all that their pictures are made of. Throws Error(runtime) where the pipeline
/// is to stop.
template <class Pixel>
std::vector<Share<Pixel>> shares_of(Pipeline& pipeline, std::span<const Recipe> recipes,
                                    const std::vector<MaterialPicture>& wanted, Packing packing,
                                    bool rough_levels) {
    std::vector<Share<Pixel>> shares;
    for_each_share(pipeline, recipes, [&](const Recipe& recipe) {
        const StageContext& context = pipeline.context();
        const std::vector<MaterialPicture> own = material_pictures(recipe, packing, rough_levels);
        std::vector<std::size_t> places{0};
        for (const MaterialPicture& one : own)
            places.push_back(
                1 + std::size_t(std::ranges::find(wanted, one.name, &MaterialPicture::name) -
                                wanted.begin()));
        MaskImages masks =
            pipeline.masks()(pipeline.solid(), recipe.texture, GraphOutput::planes, context.stop);
        if (context.stop.stop_requested()) throw was_stopped();
        shares.push_back({with_own_maps(pipeline.solid()), std::move(places),
                          PictureBands<Pixel>(recipe, std::move(masks), plans_of(recipe, own))});
    });
    return shares;
}

/// The pixel of a normal map that has no bumps.
template <class Pixel>
Pixel flat_normal() {
    const Image<RgbF> up(1, 1, {0.0f, 0.0f, 1.0f});
    if constexpr (std::is_same_v<Pixel, Rgb8>)
        return normal_codes8(up)(0, 0);
    else if constexpr (std::is_same_v<Pixel, Rgb16>)
        return normal_codes16(up)(0, 0);
    else
        return up(0, 0);
}

bool is_mask(const Recipe& recipe) {
    return is_transparent(recipe) && recipe.material.alpha == AlphaMode::mask;
}

}  // namespace

std::vector<MaterialPicture> shared_material_pictures(std::span<const Recipe> recipes,
                                                      Packing packing, bool rough_levels) {
    std::vector<MaterialPicture> all;
    for (const Recipe& recipe : recipes)
        for (MaterialPicture& one : material_pictures(recipe, packing, rough_levels))
            if (std::ranges::find(all, one.name, &MaterialPicture::name) == all.end())
                all.push_back(std::move(one));
    return all;
}

bool any_transparent(std::span<const Recipe> recipes) {
    return std::ranges::any_of(recipes, is_transparent);
}

std::optional<double> mask_cutoff(std::span<const Recipe> recipes) {
    const auto mask = std::ranges::find_if(recipes, is_mask);
    if (mask == recipes.end()) return std::nullopt;
    return mask->material.alpha_cutoff;
}

template <class Pixel>
std::vector<Image<Pixel>> shared_pictures(Pipeline& pipeline, std::span<const Recipe> recipes,
                                          const std::vector<MaterialPicture>& wanted,
                                          Packing packing, bool rough_levels) {
    std::vector<Image<Pixel>> all;
    shared_pictures_in_bands<Pixel>(
        pipeline, recipes, wanted, packing, rough_levels, recipes.front().atlas.size,
        [&](std::size_t, std::vector<Image<Pixel>> rows) { all = std::move(rows); });
    return all;
}

template <class Pixel>
void shared_pictures_in_bands(Pipeline& pipeline, std::span<const Recipe> recipes,
                              const std::vector<MaterialPicture>& wanted, Packing packing,
                              bool rough_levels, std::size_t rows,
                              const TakePictures<Pixel>& take) {
    StageContext& context = pipeline.context();
    const int threads = context.way.threads;
    if (recipes.size() == 1) {
        const auto take_rows = [&](std::size_t first, std::vector<Image<Pixel>> bands) {
            if (context.stop.stop_requested()) throw was_stopped();
            paint(pipeline.solid(), pipeline.recipe(), threads, first, bands[0]);
            take(first, std::move(bands));
        };
        pipeline.pictures_in_bands<Pixel>(plans_of(pipeline.recipe(), wanted), rows, take_rows);
        if (context.stop.stop_requested()) throw was_stopped();
        return;
    }
    auto shares = shares_of<Pixel>(pipeline, recipes, wanted, packing, rough_levels);
    const std::size_t size = recipes.front().atlas.size;
    context.begin(tasks::texture, texels_of(pipeline.solid()));
    for (std::size_t first = 0; first < size; first += rows) {
        std::vector<Image<Pixel>> all(1 + wanted.size());
        for (auto& [solid, places, bands] : shares) {
            std::vector<Image<Pixel>> own = bands.rows(context, solid, {first, first + rows});
            if (context.stop.stop_requested()) throw was_stopped();
            paint(solid, bands.recipe(), threads, first, own[0]);
            for (std::size_t i = 0; i < own.size(); ++i)
                place(solid, first, std::move(own[i]), all[places[i]]);
        }
        take(first, std::move(all));
    }
    for (const Share<Pixel>& share : shares) share.bands.record(context);
}

void shared_normals_in_bands(Pipeline& pipeline, std::span<const Recipe> recipes,
                             double crease_degrees, bool tangent_space, std::size_t rows,
                             const TakeNormals& take) {
    if (recipes.size() == 1)
        return pipeline.normals_in_bands(crease_degrees, tangent_space, rows, take);
    const std::size_t size = recipes.front().atlas.size;
    Image<RgbF> all(size, size, flat_normal<RgbF>());
    for_each_share(pipeline, recipes, [&](const Recipe& recipe) {
        if (recipe.bump.empty()) return;
        const auto put = [&](std::size_t first, const Image<RgbF>& band) {
            for (std::size_t y = 0; y < band.height(); ++y)
                for (const Span& span : pipeline.solid().row(first + y))
                    std::ranges::copy_n(&band(span.x, y), span.count, &all(span.x, first + y));
        };
        pipeline.normals_in_bands(crease_degrees, tangent_space, rows, put);
    });
    for (std::size_t first = 0; first < size; first += rows) {
        auto band = Image<RgbF>::unset(size, std::min(rows, size - first));
        std::ranges::copy_n(&all(0, first), std::ptrdiff_t(band.pixels().size()), &band(0, 0));
        take(first, band);
    }
}

template <class Pixel>
Image<Pixel> shared_normals(Pipeline& pipeline, std::span<const Recipe> recipes,
                            double crease_degrees, bool tangent_space) {
    if (recipes.size() == 1) return pipeline.normal_map<Pixel>(crease_degrees, tangent_space);
    const std::uint32_t size = recipes.front().atlas.size;
    Image<Pixel> all(size, size, flat_normal<Pixel>());
    for_each_share(pipeline, recipes, [&](const Recipe& recipe) {
        if (recipe.bump.empty()) return;
        place(pipeline.solid(), 0, pipeline.normal_map<Pixel>(crease_degrees, tangent_space), all);
    });
    return all;
}

void check_shared_levels(std::span<const Recipe> recipes, const std::string& where) {
    const auto mask = std::ranges::find_if(recipes, is_mask);
    if (mask == recipes.end()) return;
    for (const Recipe& recipe : recipes)
        if (is_transparent(recipe) &&
            (!is_mask(recipe) || recipe.material.alpha_cutoff != mask->material.alpha_cutoff))
            throw Error(ExitCode::usage,
                        fmt::format("{}: MIP levels of the masks of {} and {} differ in one "
                                    "atlas; add --atlas-per recipe, or leave --levels out",
                                    where, mask->name, recipe.name));
}

template std::vector<Image<Rgba8>> shared_pictures(Pipeline&, std::span<const Recipe>,
                                                   const std::vector<MaterialPicture>&, Packing,
                                                   bool);
template std::vector<Image<Rgba16>> shared_pictures(Pipeline&, std::span<const Recipe>,
                                                    const std::vector<MaterialPicture>&, Packing,
                                                    bool);
template std::vector<Image<RgbaF>> shared_pictures(Pipeline&, std::span<const Recipe>,
                                                   const std::vector<MaterialPicture>&, Packing,
                                                   bool);
template void shared_pictures_in_bands(Pipeline&, std::span<const Recipe>,
                                       const std::vector<MaterialPicture>&, Packing, bool,
                                       std::size_t, const TakePictures<Rgba8>&);
template void shared_pictures_in_bands(Pipeline&, std::span<const Recipe>,
                                       const std::vector<MaterialPicture>&, Packing, bool,
                                       std::size_t, const TakePictures<Rgba16>&);
template void shared_pictures_in_bands(Pipeline&, std::span<const Recipe>,
                                       const std::vector<MaterialPicture>&, Packing, bool,
                                       std::size_t, const TakePictures<RgbaF>&);
template Image<Rgb8> shared_normals(Pipeline&, std::span<const Recipe>, double, bool);
template Image<Rgb16> shared_normals(Pipeline&, std::span<const Recipe>, double, bool);
template Image<RgbF> shared_normals(Pipeline&, std::span<const Recipe>, double, bool);

}  // namespace burl
