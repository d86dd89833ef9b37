#pragma once
// Diffuse light as spherical harmonics (Ramamoorthi and Hanrahan 2001).
#include <array>

#include "app/light/environment.h"

namespace burl {

/// The coefficients of PrefilteredLight::diffuse.
std::array<Vec3f, 9> diffuse_harmonics(const Environment& environment);

}  // namespace burl
