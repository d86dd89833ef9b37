#pragma once
// Numbers of a recipe keyed over time, as data of the recipe; app/recipe/keyed_recipe.h evaluates
// them.
#include <string>
#include <vector>

#include "atlas/base/enum_names.h"

namespace burl {

struct KeyPoint {
    double seconds = 0.0;  ///< the time, at least 0
    double value = 0.0;
    bool operator==(const KeyPoint&) const = default;
};

/// The interpolation between two keys.
enum class KeyEase {
    linear,
    smooth  ///< smoothstep, 3 x^2 - 2 x^3: at rest in every key
};
template <>
inline constexpr auto enum_names<KeyEase> = enum_words("linear", "smooth");

/// The keys of one number of a recipe.
struct KeyTrack {
    /// The dotted path, such as "texture.input.noise.0.phase.2".
    std::string path{};
    KeyEase ease = KeyEase::linear;
    std::vector<KeyPoint> keys{};  ///< the keys, ascending by distinct times
    bool operator==(const KeyTrack&) const = default;
};

struct KeyedAnimation {
    double seconds = 2.0;  ///< the animation's length
    int rate = 24;         ///< frames per second
    bool loop = false;     ///< the end coincides with the beginning
    std::vector<KeyTrack> tracks{};
    bool operator==(const KeyedAnimation&) const = default;
};

}  // namespace burl
