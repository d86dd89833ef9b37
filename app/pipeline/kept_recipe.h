#pragma once
// A recipe as a step of an undo history: strokes of paint, of which a picture may have megabytes,
// share memory with equal strokes of the step before.
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/recipe/recipe.h"

namespace burl {

/// A recipe whose strokes may be shared with other steps.
class KeptRecipe {
  public:
    explicit KeptRecipe(Recipe recipe) : KeptRecipe(std::move(recipe), {}) {}
    /// Shares every stroke that equals the stroke of the same index in the step `before`.
    KeptRecipe(Recipe recipe, const KeptRecipe& before)
        : KeptRecipe(std::move(recipe), before.paint_) {}

    /// The whole recipe, with copies of the strokes.
    Recipe recipe() const;
    /// Renames the recipe's images as with_images_for does (app/recipe/edit/images.h).
    void name_images(const std::string& from, const std::string& to);
    /// The number of strokes that share their memory with another step.
    std::size_t shared_strokes() const;

  private:
    using Strokes = std::vector<std::shared_ptr<const PaintStroke>>;
    KeptRecipe(Recipe recipe, const Strokes& before);

    Recipe rest_;  ///< the recipe without paint
    Strokes paint_;
};

}  // namespace burl
