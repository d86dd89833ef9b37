#pragma once
// The material of a recipe besides its texture: numbers and colours of channels that are the same
// everywhere. Channels that vary over the surface are nodes of the recipe's graph. Names, ranges
// and meaning are those of glTF 2.0 and its material extensions.
#include "atlas/base/enum_names.h"
#include "atlas/base/image.h"

namespace burl {

/// The use that a bake makes of a base colour's alpha.
enum class AlphaMode {
    blend,  ///< the surface lets through what is behind it
    mask,   ///< a texel is there or not, by the cutoff
    opaque  ///< what is transparent shows black
};
template <>
inline constexpr auto enum_names<AlphaMode> = enum_words("blend", "mask", "opaque");

/// The channels that do not vary; the defaults are those of every recipe without a material.
struct Material {
    double opacity = 1.0, metallic = 0.0, roughness = 0.6, occlusion = 1.0;
    Rgb8 emissive{};                 ///< sRGB
    double emissive_strength = 1.0;  ///< factor of emissive, whether a colour or a node
    double ior = 1.5;                ///< refractive index of a dielectric
    double specular = 1.0;
    double clearcoat = 0.0, clearcoat_roughness = 0.0;
    Rgb8 sheen{};  ///< sRGB
    double sheen_roughness = 0.0;
    double transmission = 0.0;
    AlphaMode alpha = AlphaMode::blend;
    double alpha_cutoff = 0.5;  ///< alpha from which a texel is there, for AlphaMode::mask
    bool operator==(const Material&) const = default;
};

}  // namespace burl
