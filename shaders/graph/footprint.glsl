// A texture graph's colour over the texel's footprint, as in procedural/fill/graph_texels.h. This
// part must follow texture_color and maps/texel_line.glsl.
uniform real3 texture_from_atlas[4];  // three columns and the offset

real3 footprint_color(ivec2 texel) {
    uint owner = texelFetch(span_map, texel, 0).x;
    if (owner == 0xffffffffu) return texture_color(real3(0.0), real3(0.0), real3(0.0));
    TexelMapping map = texel_mapping(int(owner));
    real3 x = texture_from_atlas[0], y = texture_from_atlas[1], z = texture_from_atlas[2];
    exact real3 point = along(x, y, z, texel_point(map, texel + tile_origin)) + texture_from_atlas[3];
    return texture_color(point, along(x, y, z, map.step), along(x, y, z, map.down));
}
