#pragma once
// The widget of one parameter: a slider, box or list. Ctrl-click to type a value, double-click for
// the default, Shift to drag at a tenth of the speed.
#include <cstddef>
#include <optional>
#include <string>

#include "app/editor/panels/items.h"
#include "app/recipe/edit/leaves.h"

namespace burl {

/// The range of a parameter's slider: the table's range if it is narrow, otherwise 40 steps to both
/// sides of the default; widened to contain `value`.
struct SliderRange {
    double low = 0.0, high = 1.0;
};
SliderRange slider_range(const Parameter& parameter, double value);

/// An edit of a value in this frame.
struct ValueEdit {
    std::optional<Json> value{};        ///< the new value
    bool began = false, ended = false;  ///< whether a gesture began or ended
    std::size_t item = 0;               ///< index of the edited number in a parameter of several
};

/// The scale of a slider's values along it.
enum class SliderScale {
    linear,
    logarithmic  ///< equal ways are equal factors; the range must be above 0
};

/// Draws the widget of a leaf, then `label` with the leaf's description as tip, and returns the
/// edit. `scale` is that of a single number's slider. Items are the leaf's path, or "path.0",
/// "path.1" and so on for several numbers.
ValueEdit edit_leaf(const RecipeLeaf& leaf, const std::string& label, EditItems& items,
                    SliderScale scale = SliderScale::linear);

}  // namespace burl
