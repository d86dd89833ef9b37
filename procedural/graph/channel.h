#pragma once
// The channels of a material: what a surface is besides its base colour, each a number or a colour
// per texel. Names and meaning are those of glTF 2.0 and its extensions.
#include <cstdint>

#include "atlas/base/enum_names.h"

namespace burl {

/// A channel besides the base colour. Emissive and sheen are colours in linear light, the others
/// numbers from 0 to 1.
enum class Channel : std::uint8_t {
    opacity,              ///< factor of the base colour's alpha
    metallic,             ///< 0: dielectric, 1: metal
    roughness,            ///< perceptual roughness, the square root of GGX's alpha
    occlusion,            ///< share of the sky that is seen
    emissive,             ///< light that the surface gives by itself
    specular,             ///< factor of a dielectric's reflection
    clearcoat,            ///< weight of a layer of varnish
    clearcoat_roughness,  ///< its roughness
    sheen,                ///< colour of a fabric's sheen
    sheen_roughness,      ///< its roughness
    transmission          ///< share of light that passes through
};
template <>
inline constexpr auto enum_names<Channel> = enum_words("opacity", "metallic", "roughness",
                                                       "occlusion", "emissive", "specular",
                                                       "clearcoat", "clearcoat_roughness", "sheen",
                                                       "sheen_roughness", "transmission");

/// Whether the channel is a colour rather than a number.
constexpr bool is_color(Channel channel) {
    return channel == Channel::emissive || channel == Channel::sheen;
}

}  // namespace burl
