#pragma once
// Lists of recipes on the command line: "oak,walnut,*marble*".
#include <string>
#include <vector>

namespace burl {

/// The recipes that the texts name, each once, in their order: a text is a list with commas of
/// presets, materials, files (.json) and patterns of names, in which * stands for any letters and ?
/// for one. Names that a pattern fits come presets first, in alphabetical order. Throws
/// Error(usage) for an empty name, and for a pattern that fits none; other names are taken as they
/// are.
std::vector<std::string> recipes_named(const std::vector<std::string>& texts);

}  // namespace burl
