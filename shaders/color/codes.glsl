// 8-bit sRGB codes of field values, those of ColorTable8 in procedural/color/table.h, from the
// tables of procedural/glsl/colors.h. This part must follow numbers/real_bits.glsl and
// color/index.glsl. COLOR_ENTRIES is the number of entries as a float, COLOR_STEPS the largest
// number of steps in one.
uniform usamplerBuffer color_entries;
#if COLOR_STEPS > 1
uniform usamplerBuffer color_first, color_steps;
#endif

// The code r + 2^8 g + 2^16 b of c(f).
uint color_code(real f) {
    real t = color_index(f);
    int entry = int(t * real(COLOR_ENTRIES));
    uvec4 begin = texelFetch(color_entries, entry);
    uint code = t >= real_from_bits(begin.y, begin.z) ? begin.w : begin.x;
#if COLOR_STEPS > 1
    // A short loop has no early exit, because it is unrolled and texels run side by side.
    int first = int(texelFetch(color_first, entry).x);
    for (int i = 2; i <= COLOR_STEPS; ++i) {
        uvec4 step = texelFetch(color_steps, first + i);
        bool reached = t >= real_from_bits(step.x, step.y);
        if (reached) code = step.z;
#if COLOR_STEPS > 4
        if (!reached) break;
#endif
    }
#endif
    return code;
}
