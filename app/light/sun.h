#pragma once
// A sun: the one small spot of an environment that outshines the rest. It is shaded as a round
// light of its own, since neither nine harmonics nor a cube map's levels hold it.
#include "app/light/environment.h"

namespace burl {

/// A round light infinitely far away.
struct Sun {
    Vec3f direction{0.0f, 1.0f, 0.0f};  ///< unit
    Vec3f light{0.0f};                  ///< radiance times solid angle; 0: there is no sun
    float radius = 0.0f;                ///< in radians, > 0 where there is a sun

    bool shines() const { return light != Vec3f(0.0f); }
};

/// An environment as its sun and the rest.
struct SunAndSky {
    Sun sun;
    Environment sky;
};

/// Takes the sun from an environment: what exceeds 16 times the mean luminance within 5 degrees of
/// the brightest pixel, if that is at least a twentieth of all light and as compact as a disc of at
/// most 3.5 degrees' radius. The disc has the light, the middle and the mean square width of what
/// was taken. Without such a spot the sky is the environment.
SunAndSky without_sun(const Environment& environment);

}  // namespace burl
