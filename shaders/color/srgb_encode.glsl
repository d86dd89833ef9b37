// sRGB codes in [0, 1] of linear light (IEC 61966-2-1), without the exact rounding of textures: for
// pictures that only people look at.
vec3 srgb_encoded(vec3 linear) {
    vec3 c = clamp(linear, 0.0, 1.0);
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThan(c, vec3(0.0031308)));
}
