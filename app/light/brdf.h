#pragma once
// What a surface does with light, as glTF 2.0 defines metallic-roughness materials and their
// extensions: GGX microfacets (Walter et al. 2007) with Smith's height-correlated masking (Heitz
// 2014), Schlick's Fresnel, Lambert's diffuse light, and compensation of what is reflected more
// than once (Fdez-Aguera 2019). shaders/draw/light.glsl repeats ambient_shading().
#include "app/light/prefilter.h"
#include "atlas/base/vec.h"

namespace burl {

/// A material at one point. Colours are linear.
struct ShadedPoint {
    Vec3d base{1.0};         ///< base colour, 0..1
    double metallic = 0.0;   ///< 0..1
    double roughness = 1.0;  ///< perceptual; GGX's alpha is its square
    double occlusion = 1.0;  ///< share of the sky that is seen, for image-based light alone
    Vec3d emissive{0.0};     ///< strength included
    double ior = 1.5;
    double specular = 1.0;  ///< KHR_materials_specular's factor; its colour is white
    double clearcoat = 0.0, clearcoat_roughness = 0.0;
    Vec3d sheen{0.0};
    double sheen_roughness = 0.0;
    double transmission = 0.0;
    /// The unit normal of the clearcoat, which glTF leaves without bumps; zero: the surface's.
    Vec3d coat_normal{0.0};
};

/// Reflectance of a dielectric at normal incidence: ((ior - 1) / (ior + 1))^2.
double dielectric_f0(double ior);

/// Light towards `view` from a point in an environment, by the prefiltered light: what drawn
/// pictures show. `normal` and `view` are unit vectors, normal . view is clamped to be positive.
Vec3d ambient_shading(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view,
                      const PrefilteredLight& light);

/// The fraction of light from unit direction `light` that goes to `view`, times |normal . light|:
/// the function itself, for renderers that sum over directions. Directions below the surface count
/// where it transmits. Emission is left out.
Vec3d reflected(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view,
                const Vec3d& light);

/// The light that the surface gives by itself, less what its clearcoat keeps.
Vec3d emitted(const ShadedPoint& point, const Vec3d& normal, const Vec3d& view);

}  // namespace burl
