#include "app/bake/shared_pictures.h"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "app/paint/texture.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

/// Copies the texels that spans show; takes the whole image where there is none yet.
template <class Pixel>
void place(const SolidAtlas& shown, Image<Pixel> from, Image<Pixel>& to) {
    if (to.width() == 0) {
        to = std::move(from);
        return;
    }
    for (std::uint32_t y = 0; y < shown.size; ++y)
        for (const Span& span : shown.row(y))
            std::ranges::copy_n(&from(span.x, y), span.count, &to(span.x, y));
}

/// Paints over rows, from row `first` on, of the colour of the pipeline's recipe, which is opaque
/// where it has paint.
template <class Code>
void paint(Pipeline& pipeline, std::size_t first, Image<Rgba<Code>>& color) {
    const Recipe& recipe = pipeline.recipe();
    if (!has_color_paint(recipe.paint)) return;
    auto opaque = converted<Rgb<Code>>(color, [](const Rgba<Code>& p) {
        return Rgb<Code>{p.r, p.g, p.b};
    });
    paint_over(pipeline.solid(), recipe.paint, pipeline.context().way.threads, opaque, first);
    const Code full = std::is_floating_point_v<Code> ? Code(1) : std::numeric_limits<Code>::max();
    color = converted<Rgba<Code>>(opaque, [&](const Rgb<Code>& p) {
        return Rgba<Code>{p.r, p.g, p.b, full};
    });
}

Error was_stopped() {
    return Error(ExitCode::runtime, "the bake was stopped before it was done");
}

/// The plans of the base colour and of the pictures.
std::vector<PicturePlan> plans_of(const Pipeline& pipeline,
                                  const std::vector<MaterialPicture>& pictures) {
    std::vector<PicturePlan> plans{base_color_plan(pipeline.recipe())};
    for (const MaterialPicture& one : pictures) plans.push_back(one.plan);
    return plans;
}

/// Level 0 of the pictures of the pipeline's recipe, the base colour first. Throws Error(runtime)
/// where the pipeline is to stop, which leaves none.
template <class Pixel>
std::vector<Image<Pixel>> own_pictures(Pipeline& pipeline,
                                       const std::vector<MaterialPicture>& pictures) {
    std::vector<Image<Pixel>> images = pipeline.pictures<Pixel>(plans_of(pipeline, pictures));
    if (images.empty()) throw was_stopped();
    paint(pipeline, 0, images[0]);
    return images;
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
    if (recipes.size() == 1) return own_pictures<Pixel>(pipeline, wanted);
    std::vector<Image<Pixel>> all(1 + wanted.size());
    for_each_share(pipeline, recipes, [&](const Recipe& recipe) {
        const std::vector<MaterialPicture> own = material_pictures(recipe, packing, rough_levels);
        std::vector<Image<Pixel>> images = own_pictures<Pixel>(pipeline, own);
        place(pipeline.solid(), std::move(images[0]), all[0]);
        for (std::size_t i = 0; i < own.size(); ++i) {
            const auto at = std::ranges::find(wanted, own[i].name, &MaterialPicture::name);
            place(pipeline.solid(), std::move(images[i + 1]),
                  all[1 + std::size_t(at - wanted.begin())]);
        }
    });
    return all;
}

template <class Pixel>
void shared_pictures_in_bands(Pipeline& pipeline, std::span<const Recipe> recipes,
                              const std::vector<MaterialPicture>& wanted, Packing packing,
                              bool rough_levels, std::size_t rows,
                              const TakePictures<Pixel>& take) {
    if (recipes.size() > 1)
        return take(0, shared_pictures<Pixel>(pipeline, recipes, wanted, packing, rough_levels));
    const auto take_rows = [&](std::size_t first, std::vector<Image<Pixel>> bands) {
        paint(pipeline, first, bands[0]);
        take(first, std::move(bands));
    };
    pipeline.pictures_in_bands<Pixel>(plans_of(pipeline, wanted), rows, take_rows);
    if (pipeline.context().stop.stop_requested()) throw was_stopped();
}

void shared_normals_in_bands(Pipeline& pipeline, std::span<const Recipe> recipes,
                             double crease_degrees, bool tangent_space, std::size_t rows,
                             const TakeNormals& take) {
    if (recipes.size() > 1)
        return take(0, shared_normals<RgbF>(pipeline, recipes, crease_degrees, tangent_space));
    pipeline.normals_in_bands(crease_degrees, tangent_space, rows, take);
}

template <class Pixel>
Image<Pixel> shared_normals(Pipeline& pipeline, std::span<const Recipe> recipes,
                            double crease_degrees, bool tangent_space) {
    if (recipes.size() == 1) return pipeline.normal_map<Pixel>(crease_degrees, tangent_space);
    const std::uint32_t size = recipes.front().atlas.size;
    Image<Pixel> all(size, size, flat_normal<Pixel>());
    for_each_share(pipeline, recipes, [&](const Recipe& recipe) {
        if (recipe.bump.empty()) return;
        place(pipeline.solid(), pipeline.normal_map<Pixel>(crease_degrees, tangent_space), all);
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
