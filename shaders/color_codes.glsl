// 8-bit sRGB codes of field values, those of ColorTable8 in procedural/color_table.h, from the
// tables of procedural/glsl_colors.h. After real_bits.glsl and color_index.glsl. COLOR_ENTRIES is
// their number as a float; COLOR_SEVERAL is 1 where an entry may hold several steps.
uniform usamplerBuffer color_entries;
#if COLOR_SEVERAL
uniform usamplerBuffer color_first, color_steps;
#endif

// r + 2^8 g + 2^16 b.
uint color_code(real f) {
    real t = color_index(f);
    int entry = int(t * real(COLOR_ENTRIES));
    uvec4 begin = texelFetch(color_entries, entry);
    bool reached = t >= real_from_bits(begin.y, begin.z);
    uint code = reached ? begin.w : begin.x;
#if COLOR_SEVERAL
    int i = int(texelFetch(color_first, entry).x) + 2;
    while (reached) {
        uvec4 step = texelFetch(color_steps, i);
        reached = t >= real_from_bits(step.x, step.y);
        if (reached) code = step.z;
        ++i;
    }
#endif
    return code;
}
