// Colours in linear light by number, two texels each. This part must follow numbers/real_bits.glsl.
uniform usamplerBuffer color_table;
uniform real3 background;  // colour of texels that no span shows

real3 table_color(int i) {
    uvec4 xy = texelFetch(color_table, 2 * i), z = texelFetch(color_table, 2 * i + 1);
    return real3(real_from_bits(xy.x, xy.y), real_from_bits(xy.z, xy.w), real_from_bits(z.x, z.y));
}
