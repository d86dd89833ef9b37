#pragma once
// The tone curve: Khronos PBR Neutral (Khronos Group, "PBR Neutral Tone Mapper" specification,
// 2024). It takes away the 0.04 that a dielectric reflects of white light, leaves the rest of
// colours up to 0.8 as it is, and compresses what is brighter.
#include "app/light/light.h"
#include "atlas/base/vec.h"

namespace burl {

/// Linear light of 0 and more to linear light in 0..1.
Vec3d tone_mapped(const Vec3d& light);

/// Linear light as a picture shows it, before it is encoded: exposure, then the tone curve. The
/// headlight's light stays as it is but for its exposure.
Vec3d developed(const Vec3d& light, const LightOptions& options);

}  // namespace burl
