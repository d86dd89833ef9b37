#pragma once
// An environment prepared for image-based light in real time: diffuse light as spherical
// harmonics (Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment
// Maps", 2001), glossy light as a cube map with a level per roughness (Karis, "Real Shading in
// Unreal Engine 4", 2013), and the table of what a glossy surface reflects altogether.
#include <array>
#include <cstddef>
#include <vector>

#include "app/light/environment.h"
#include "app/light/sun.h"
#include "atlas/base/image.h"
#include "atlas/base/vec.h"

namespace burl {

/// Faces of a cube map in OpenGL's order and orientation: +x, -x, +y, -y, +z, -z.
using CubeFaces = std::array<Image<RgbF>, 6>;

/// An environment ready for a shader: its sun, and in all else what it is without the sun.
struct PrefilteredLight {
    Sun sun{};
    /// Coefficients of irradiance / pi in the real spherical harmonics of degree 0 to 2, ready to
    /// be multiplied by 1; y, z, x; xy, yz, 3z^2-1, xz, x^2-y^2 of the unit normal.
    std::array<Vec3f, 9> diffuse{};
    /// Level k holds the mean of light over GGX lobes of perceptual roughness k / (levels - 1), for
    /// a view along the normal; level 0 is the environment itself. Sides halve from level to level.
    std::vector<CubeFaces> glossy{};
};

/// Prepares an environment; `side` is that of level 0's faces. Deterministic for every thread
/// count.
PrefilteredLight prefilter(const Environment& environment, std::size_t side = 256);

/// The light of a diffuse surface with this unit normal, without the sun's: irradiance / pi.
Vec3d diffuse_light(const PrefilteredLight& light, const Vec3d& normal);

/// The mean light, without the sun's, over the GGX lobe of this roughness about a unit direction:
/// trilinear in the glossy levels.
Vec3d glossy_light(const PrefilteredLight& light, const Vec3d& direction, double roughness);

}  // namespace burl
