#pragma once
// Light from infinitely far away: a picture of all directions, from a file or made by formulas.
#include <span>
#include <string>
#include <string_view>

#include "atlas/base/image.h"
#include "atlas/base/vec.h"

namespace burl {

/// Radiance of every direction: linear, Rec. 709 primaries, 1 is what white paper sends back in the
/// room the light is meant for. Equirectangular, twice as wide as high; row 0 is up (+y); column
/// centres lie at azimuths atan2(z, x) = 2 pi (u - 1/2), so that the middle looks along +x, as
/// three.js and Blender (through glTF's axes) read such files.
struct Environment {
    Image<RgbF> radiance;
};

/// A built-in environment, with a sentence for people.
struct EnvironmentNote {
    std::string_view name, sentence;
    double paper = 0.8;  ///< luminance of a white ball's upper half in it, on average
};

/// The built-in environments in the order of `burl list environments`: studio, overcast, sun,
/// dusk, warehouse, neutral.
std::span<const EnvironmentNote> environment_notes();

/// A built-in environment by its name, `height` rows high. Throws Error(usage) for another name.
Environment make_environment(std::string_view name, std::size_t height = 256);

/// An environment from a picture, .exr or .hdr (Radiance RGBE), of any size with sides 2:1. Throws
/// Error: io, invalid_file (no such picture, NaN, negative or infinite light), unsupported.
Environment load_environment(const std::string& path);

/// The environment turned by `azimuth` degrees about +y: a light along +z comes from +x after 90.
Environment turned(const Environment& environment, double azimuth);

/// The light from a direction of any length but 0: bilinear between the pixels' centres.
Vec3d light_from(const Environment& environment, const Vec3d& direction);

/// The light at a point of the map, u and v in 0 to 1: bilinear between the pixels' centres.
Vec3d light_at(const Environment& environment, const Vec2d& uv);

/// The point of the equirectangular map that a direction of any length sees: u, v in 0..1, v = 0
/// up.
Vec2d equirectangular(const Vec3d& direction);
/// The unit direction that u, v of the map see.
Vec3d direction_at(const Vec2d& uv);

}  // namespace burl
