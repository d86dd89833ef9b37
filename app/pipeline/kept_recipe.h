#pragma once
// A recipe as one of many steps of an undo history keeps it: strokes of paint, of which a picture
// may have megabytes, are those of the step before wherever they are equal.
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/recipe/recipe.h"

namespace burl {

class KeptRecipe {
  public:
    explicit KeptRecipe(Recipe recipe) : KeptRecipe(std::move(recipe), {}) {}
    /// `before`: the step before.
    KeptRecipe(Recipe recipe, const KeptRecipe& before)
        : KeptRecipe(std::move(recipe), before.paint_) {}

    Recipe recipe() const;
    /// Does what with_images_for does (app/recipe/images.h).
    void name_images(const std::string& from, const std::string& to);
    /// How many strokes take no memory besides that of another step.
    std::size_t shared_strokes() const;

  private:
    using Strokes = std::vector<std::shared_ptr<const PaintStroke>>;
    KeptRecipe(Recipe recipe, const Strokes& before);

    Recipe rest_;  ///< without paint
    Strokes paint_;
};

}  // namespace burl
