#pragma once
// Numbers of a recipe keyed over time, as data of the recipe: between keys they go linearly.
#include <string>
#include <vector>

namespace burl {

struct KeyPoint {
    double seconds = 0.0;  ///< from 0 on
    double value = 0.0;
    bool operator==(const KeyPoint&) const = default;
};

/// One number of a recipe, such as "texture.input.noise.0.phase.2".
struct KeyTrack {
    std::string path{};
    std::vector<KeyPoint> keys{};  ///< in the order of their times
    bool operator==(const KeyTrack&) const = default;
};

struct KeyedAnimation {
    double seconds = 2.0;  ///< of the whole
    bool loop = false;     ///< the end is the beginning
    std::vector<KeyTrack> tracks{};
    bool operator==(const KeyedAnimation&) const = default;
};

}  // namespace burl
