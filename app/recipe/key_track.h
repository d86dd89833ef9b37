#pragma once
// Numbers of a recipe keyed over time, as data of the recipe (app/recipe/keyed_recipe.h says what
// they are at a time).
#include <string>
#include <vector>

namespace burl {

struct KeyPoint {
    double seconds = 0.0;  ///< from 0 on
    double value = 0.0;
    bool operator==(const KeyPoint&) const = default;
};

/// How a number goes from one key to the next.
enum class KeyEase {
    linear,
    smooth  ///< at rest in every key: 3 x^2 - 2 x^3
};

/// One number of a recipe, such as "texture.input.noise.0.phase.2".
struct KeyTrack {
    std::string path{};
    KeyEase ease = KeyEase::linear;
    std::vector<KeyPoint> keys{};  ///< in the order of their times, of which none is there twice
    bool operator==(const KeyTrack&) const = default;
};

struct KeyedAnimation {
    double seconds = 2.0;  ///< of the whole
    int rate = 24;         ///< frames a second
    bool loop = false;     ///< the end is the beginning
    std::vector<KeyTrack> tracks{};
    bool operator==(const KeyedAnimation&) const = default;
};

}  // namespace burl
