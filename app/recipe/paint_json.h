#pragma once
// Strokes of paint as a recipe's JSON has them (docs/reference/recipes.md, "Paint").
#include <vector>

#include "app/base/json_text.h"
#include "app/recipe/paint_stroke.h"

namespace burl {

/// `json` must have passed the parameter table (app/recipe/check.h): an array of strokes.
std::vector<PaintStroke> paint_from_json(const Json& json);

/// JSON that paint_from_json reads back to equal strokes.
Json paint_to_json(const std::vector<PaintStroke>& strokes);

}  // namespace burl
