// Linear light of field values, that of PreparedColorMap in procedural/color/table.h, from the
// table of procedural/glsl/colors.h. This part must follow numbers/real_bits.glsl and
// color/index.glsl.
uniform usamplerBuffer color_segments;
uniform int color_segment_count;

real color_segment_begin(int i) {
    uvec4 texel = texelFetch(color_segments, 4 * i);
    return real_from_bits(texel.x, texel.y);
}

real3 linear_color(real f) {
    real t = color_index(f), begin = color_segment_begin(0);
    int i = 0;
    for (; i + 1 < color_segment_count; ++i) {
        real next = color_segment_begin(i + 1);
        if (!(t >= next)) break;
        begin = next;
    }
    uvec4 x = texelFetch(color_segments, 4 * i), yz = texelFetch(color_segments, 4 * i + 1);
    uvec4 slope = texelFetch(color_segments, 4 * i + 2), rest = texelFetch(color_segments, 4 * i + 3);
    exact real3 color = real3(real_from_bits(x.z, x.w), real_from_bits(yz.x, yz.y), real_from_bits(yz.z, yz.w)) +
                        (t - begin) * real3(real_from_bits(slope.x, slope.y), real_from_bits(slope.z, slope.w),
                                            real_from_bits(rest.x, rest.y));
    return color;
}
