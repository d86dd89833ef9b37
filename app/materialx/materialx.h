#pragma once
// MaterialX documents as recipes.
#include <string>
#include <string_view>
#include <vector>

namespace burl {

/// A recipe made of a document, and what the recipe lacks of the material.
struct MaterialXRecipe {
    std::string json;
    std::vector<std::string> losses;
};

/// The parts of a recipe's path: a file, and the material that is chosen of a document.
struct MaterialXPath {
    std::string file;
    std::string material;  ///< empty: the document's only one
};

/// Whether the path is that of a document, "oak.mtlx" or "woods.mtlx#oak".
bool names_materialx(std::string_view path);

/// The file of a recipe's path, and the material behind "#", which only documents have.
MaterialXPath materialx_path(const std::string& path);

/// Makes a recipe of the text of a document at `path`. Throws Error(invalid_file) with the line for
/// a document that is wrong, Error(usage) where `path` names no material and the document has
/// several, or another one, and Error(unsupported) with all nodes that are not read.
MaterialXRecipe recipe_of_materialx(const std::string& text, const std::string& path);

}  // namespace burl
