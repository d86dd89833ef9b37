// 16-bit sRGB codes of linear light, those of SrgbEncoder in procedural/color/srgb.h, from the
// thresholds between codes. This part must follow numbers/real_bits.glsl. SRGB_BUCKETS is the
// number of buckets as a float.
uniform usamplerBuffer srgb_first, srgb_thresholds;

uint srgb16(real linear) {
    if (!(linear > real(0.0))) return 0u;
    if (linear >= real(1.0)) return 65535u;
    uint code = texelFetch(srgb_first, int(sqrt(float(linear)) * SRGB_BUCKETS)).x;
    for (; code < 65535u; ++code) {
        uvec4 threshold = texelFetch(srgb_thresholds, int(code));
        if (!(linear >= real_from_bits(threshold.x, threshold.y))) break;
    }
    return code;
}
