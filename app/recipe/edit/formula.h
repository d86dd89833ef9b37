#pragma once
// Formulas of one variable x, which controls (controls.h) set further numbers by.
#include <string>

namespace burl {

/// The problem of a formula's text, as the end of a sentence; empty where there is none. A formula
/// has numbers, x, + - * /, parentheses, and the functions sqrt(a), abs(a), pow(a, b), min(a, b,
/// ...) and max(a, b, ...); nothing else, and no more than 200 characters.
std::string formula_problem(const std::string& formula);

/// The formula's value; not finite where it has none. The text must have no problem. Its bits are
/// those of every machine: powers are those of atlas/base/elementary.h.
double formula_value(const std::string& formula, double x);

}  // namespace burl
