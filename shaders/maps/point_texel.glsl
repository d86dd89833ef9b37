// A texel's point from a point map (procedural/batch/point_map.h). This part must follow
// numbers/real_bits.glsl.
uniform usampler2D point_xy, point_z_owner;

// The texel's point; outside every span the origin, whose colour such texels get.
real3 solid_point(ivec2 texel) {
    uvec4 xy = texelFetch(point_xy, texel, 0), z = texelFetch(point_z_owner, texel, 0);
    if (z.z == 0xffffffffu) return real3(0.0);
    return real3(real_from_bits(xy.x, xy.y), real_from_bits(xy.z, xy.w), real_from_bits(z.x, z.y));
}
