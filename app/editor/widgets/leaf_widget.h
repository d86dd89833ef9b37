#pragma once
// The row of one parameter: its name, then a slider, box or list. Double-click for the value that
// the recipe was opened with, and again for the parameter's default.
#include <cstddef>
#include <optional>
#include <string>

#include "app/editor/widgets/items.h"
#include "app/editor/widgets/slider.h"
#include "app/recipe/edit/leaves.h"

namespace burl {

/// The range of a parameter's slider: the table's range if it is narrow, otherwise 40 steps to both
/// sides of the default; widened to contain `value`.
SliderRange slider_range(const Parameter& parameter, double value);

/// An edit of a value in this frame.
struct ValueEdit {
    std::optional<Json> value{};        ///< the new value
    bool began = false, ended = false;  ///< whether a gesture began or ended
    std::size_t item = 0;               ///< index of the edited number in a parameter of several
};

/// Properties of a row besides the leaf.
struct LeafRow {
    std::string label{};
    SliderScale scale = SliderScale::linear;  ///< of a single number's slider
    /// The value that the recipe was opened with; null: it had none.
    const Json* opened = nullptr;
    float room = 0.0f;  ///< left free at the row's end, in screen coordinates
};

/// Draws a leaf's row and returns the edit. The leaf's sentence is the tip of both. Items are the
/// leaf's path, or "path.0", "path.1" and so on for several numbers.
ValueEdit edit_leaf(const RecipeLeaf& leaf, const LeafRow& row, EditItems& items);

}  // namespace burl
