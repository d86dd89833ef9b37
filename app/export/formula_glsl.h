#pragma once
// Formulas of controls (app/recipe/edit/formula.h) as GLSL.
#include <string>

namespace burl {

/// The formula, which must have no problem, as an expression of type float, `x` being that of its
/// variable. Powers are calls of `formula_power`. Empty where GLSL has no equal of it: where a
/// number of it is beyond float32.
std::string formula_glsl(const std::string& formula, const std::string& x);

/// The definition of formula_power.
extern const char* const formula_power_glsl;

}  // namespace burl
