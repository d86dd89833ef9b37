#pragma once
// One slider, box or list for a parameter of the table: Ctrl-click to type, double-click for the
// default, Shift to drag at a tenth of the speed.
#include <optional>

#include <nlohmann/json.hpp>

#include "app/editor/panels/items.h"
#include "app/recipe/leaves.h"

namespace burl {

/// What a person did to a value in this frame.
struct ValueEdit {
    std::optional<Json> value{};        ///< the new value
    bool began = false, ended = false;  ///< a gesture
    std::size_t item = 0;               ///< of several numbers the one under the hand
    explicit operator bool() const { return value || began || ended; }
};

/// What a slider of the parameter reaches from: the table's range where that is narrow, else some
/// steps about the default; always widened to hold `value`.
struct SliderRange {
    double low = 0.0, high = 1.0;
};
SliderRange slider_range(const Parameter& parameter, double value);

/// Draws the item; notes it under the leaf's path (of several numbers "path.0", ...).
ValueEdit edit_leaf(const RecipeLeaf& leaf, EditItems& items);

}  // namespace burl
