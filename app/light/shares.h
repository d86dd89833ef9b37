#pragma once
// How white light from all sides leaves a surface: the shares of its ways, which the shading by
// prefiltered light and the lobes that are summed over directions have in common.
#include "app/light/brdf.h"

namespace burl {

/// Reflectance of a clearcoat at normal incidence: its refractive index is 1.5.
inline constexpr double coat_f0 = 0.04;

/// A cosine of the view as surfaces count it, 1e-4 to 1.
double view_cosine(double cosine);

/// The view, at least view_cosine(0) above the normal's horizon: bumps may turn away from it.
Vec3d lifted(const Vec3d& view, const Vec3d& normal);

/// Shares of white light that glossy reflection sends back: once, and more than once (Fdez-Aguera
/// 2019).
struct Scattered {
    Vec3d once{0.0}, more{0.0};
};

/// F0 and F90 of a glossy lobe.
struct Fresnel {
    Vec3d f0{0.0};
    double f90 = 1.0;
};

/// The shares of white light that leave a surface towards a view, by their ways. The glossy,
/// diffuse and transmitted ones are those below sheen and coat.
struct Shares {
    double albedo = 1.0;  ///< of the glossy lobe, were F0 1
    Fresnel fresnel;      ///< of the glossy lobe: dielectric and metal by their parts
    Scattered glossy;
    Vec3d diffuse{0.0}, through{0.0};
    double sheen_albedo = 0.0;  ///< of sheen of colour 1
    double below_sheen = 1.0;   ///< what sheen leaves of all other light
    double coat = 0.0;          ///< the weight of the coat
    double below_coat = 1.0;    ///< what it leaves of all that is below
    /// Shares of diffuse, glossy and the coat's light that occlusion leaves.
    double diffuse_open = 1.0, glossy_open = 1.0, coat_open = 1.0;
};

/// The shares at a point with a unit normal, towards a unit view.
Shares shares_of(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view);

/// The unit normal of the clearcoat.
Vec3d coat_normal_of(const ShadedPoint& point, const Vec3d& normal);

}  // namespace burl
