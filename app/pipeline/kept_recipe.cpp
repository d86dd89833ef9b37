#include "app/pipeline/kept_recipe.h"

#include <algorithm>
#include <utility>

#include "app/recipe/edit/images.h"

namespace burl {

KeptRecipe::KeptRecipe(Recipe recipe, const Strokes& before) {
    const std::vector<PaintStroke> strokes = std::exchange(recipe.paint, {});
    rest_ = std::move(recipe);
    for (std::size_t k = 0; k < strokes.size(); ++k) {
        const bool same = k < before.size() && *before[k] == strokes[k];
        paint_.push_back(same ? before[k] : std::make_shared<const PaintStroke>(strokes[k]));
    }
}

Recipe KeptRecipe::recipe() const {
    Recipe recipe = rest_;
    for (const auto& stroke : paint_) recipe.paint.push_back(*stroke);
    return recipe;
}

void KeptRecipe::name_images(const std::string& from, const std::string& to) {
    rest_ = with_images_for(std::move(rest_), from, to);
}

std::size_t KeptRecipe::shared_strokes() const {
    return std::size_t(
        std::ranges::count_if(paint_, [](const auto& stroke) { return stroke.use_count() > 1; }));
}

}  // namespace burl
