// The colour map's index of the field: quadric, constant and the sum of the octaves. This part must
// follow passes/multipass.glsl, numbers/real_bits.glsl and color/index.glsl.
uniform uvec2 constant, amplitude;

vec4 field_index_pass() {
    real quadric = real_from_bits(texelFetch(map_places, texel(), 0).w,
                                  texelFetch(map_cells, texel(), 0).w);
    real sum = real(numbers(first).x);
#if FIXED8
    exact real noise = real_from_bits(amplitude.x, amplitude.y) * ((sum - real(128.0)) / real(127.5));
#else
    real noise = sum;
#endif
    exact real f = (quadric + real_from_bits(constant.x, constant.y)) + noise;
    real t = color_index(f);
#if FIXED8 && COLOR_REPEATS
    return vec4(float(floor(real(256.0) * t)));
#elif FIXED8
    return vec4(float(real(255.0) * t));
#else
    return vec4(float(t));
#endif
}
