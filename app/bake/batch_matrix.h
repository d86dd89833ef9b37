#pragma once
// An entry of a manifest that stands for several bakes: lists and patterns of meshes, recipes,
// sizes and all other options that take one value, and templates of file names.
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/base/json_text.h"

namespace burl {

/// How the keys of an entry are to be understood.
struct MatrixKeys {
    /// Whether the option takes one value, so that a list of them means a bake for each.
    std::function<bool(const std::string& key)> takes_one{};
    /// Whether the value of the key is a path, which may be a pattern with `*` and `?` if
    /// it is the mesh, the recipe or the pose.
    std::function<bool(const std::string& key, const std::string& value)> names_file{};
    std::string folder{};  ///< where relative patterns start
};

/// The bakes that the entry stands for: every combination of the elements of its lists, the first
/// list changing slowest, with patterns replaced by the paths that match, in alphabetical order. In
/// the values of `output`, `solid-map` and `emit-glsl`, {KEY} is replaced by that bake's value of
/// the key, and of a path by its file's name without folder and extension. An entry that is no
/// object, without lists and patterns is itself. Throws Error(invalid_file) for an empty list, a
/// pattern that nothing matches, and a {KEY} that the entry does not have.
std::vector<Json> combinations(const Json& entry, const MatrixKeys& keys);

}  // namespace burl
