#pragma once
// An entry of a manifest that stands for several bakes: lists and patterns of meshes, recipes,
// sizes and all other options that take one value, and templates of file names.
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/base/json_text.h"
#include "atlas/base/json.h"

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

/// The largest number of bakes that an entry may stand for.
inline constexpr std::size_t most_combinations = 1'000'000'000'000;

/// The bakes that an entry stands for: every combination of the elements of its lists, the first
/// list changing slowest, with patterns replaced by the paths that match, in alphabetical order. In
/// the values of `output`, `solid-map` and `emit-glsl`, {KEY} is replaced by that bake's value of
/// the key, and of a path by its file's name without folder and extension. An entry
/// without lists and patterns is itself. Bakes are made when they are asked for: of a million, a
/// shard makes its own alone.
class Combinations {
  public:
    /// Takes an entry, an object; `keys` must outlive this object. Throws Error(invalid_file) for
    /// an empty list, a pattern that nothing matches, and more than most_combinations.
    Combinations(const Json& entry, const MatrixKeys& keys);

    std::size_t count() const { return count_; }
    /// The bake number i, from 0 on. Throws Error(invalid_file) for a {KEY} that it does not have.
    Json operator[](std::size_t i) const;

  private:
    std::vector<std::pair<std::string, Json>> axes_;  ///< keys with the elements of their lists
    std::size_t count_ = 1;
    const MatrixKeys& keys_;
};

}  // namespace burl
