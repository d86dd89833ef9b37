#pragma once
// What a picture shows where nothing is drawn.
#include <cstdint>

#include "atlas/base/image.h"

namespace burl {

/// The colour behind a scene where no other is asked for, in sRGB codes.
inline constexpr Rgb8 background_srgb{176, 176, 176};

/// The background of a scene. A colour is not light: neither exposure nor the tone curve changes
/// it.
struct Background {
    enum class Kind : std::uint8_t {
        color,        ///< `color`
        transparent,  ///< nothing: the picture has alpha
        light         ///< the environment that lights the scene
    };
    Kind kind = Kind::color;
    Rgb8 color = background_srgb;
    bool operator==(const Background&) const = default;
};

}  // namespace burl
