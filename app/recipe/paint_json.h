#pragma once
// Conversion of paint strokes from and to a recipe's JSON (docs/reference/recipes.md, "Paint").
#include <vector>

#include "app/base/json_text.h"
#include "app/recipe/paint_stroke.h"

namespace burl {

/// The strokes of an array that has passed the parameter table (app/recipe/check.h).
std::vector<PaintStroke> paint_from_json(const Json& json);

/// JSON that paint_from_json reads back to equal strokes.
Json paint_to_json(const std::vector<PaintStroke>& strokes);

}  // namespace burl
