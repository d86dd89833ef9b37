#pragma once
// How a picture is lit: the user's choice as one comparable value.
#include <string>

namespace burl {

/// The light of a picture, and what becomes of it on the way to the screen.
struct LightOptions {
    /// "headlight" (shading by |n.v| alone, as pictures without materials have it), a built-in
    /// environment (app/light/environment.h), or the path of an .exr or .hdr.
    std::string light = "headlight";
    double turn = 0.0;       ///< degrees by which the environment is turned about +y
    double exposure = 0.0;   ///< in stops: light is multiplied by 2^exposure
    bool tone_curve = true;  ///< false: linear light is clipped and encoded as it is
    bool operator==(const LightOptions&) const = default;

    bool is_headlight() const { return light == "headlight"; }
};

}  // namespace burl
