// The span of an atlas that a texel lies in (atlas/solid/solid_atlas.h), and the line of solid
// points that the span shows, for shaders that evaluate points beside the texels' centres. This
// part must follow numbers/real_bits.glsl.
uniform usampler2D span_map;        // the map of procedural/maps/point_map.h
uniform usamplerBuffer texel_maps;  // TexelMap as it lies in memory, five texels each
uniform ivec2 tile_origin;          // corner of the target in the atlas

// A triangle's TexelMap (atlas/solid/solid_atlas.h).
struct TexelMapping {
    real3 origin, step, down;
    ivec2 corner;
};

TexelMapping texel_mapping(int owner) {
    int at = 5 * owner;
    uvec4 m0 = texelFetch(texel_maps, at), m1 = texelFetch(texel_maps, at + 1), m2 = texelFetch(texel_maps, at + 2),
          m3 = texelFetch(texel_maps, at + 3), m4 = texelFetch(texel_maps, at + 4);
    return TexelMapping(
        real3(real_from_bits(m0.x, m0.y), real_from_bits(m0.z, m0.w), real_from_bits(m1.x, m1.y)),
        real3(real_from_bits(m1.z, m1.w), real_from_bits(m2.x, m2.y), real_from_bits(m2.z, m2.w)),
        real3(real_from_bits(m3.x, m3.y), real_from_bits(m3.z, m3.w), real_from_bits(m4.x, m4.y)),
        ivec2(m4.zw));
}

// The solid point of a texel of the atlas, as TexelMap::operator() computes it.
real3 texel_point(TexelMapping map, ivec2 texel) {
    real across = real(texel.x - map.corner.x), up = real(texel.y - map.corner.y);
    exact real3 point = map.origin + across * map.step + up * map.down;
    return point;
}

// A span's line: texel j shows start + j step, the texel below it that plus `down`.
struct TexelLine {
    real3 start, step, down;
    real column, count;  // number j of the texel; number of texels of the span
    int owner;           // number of the triangle's map
};

// The line of a texel's span; false where no span shows anything.
bool texel_line(ivec2 texel, out TexelLine line) {
    uvec4 span = texelFetch(span_map, texel, 0);
    bool shown = span.x != 0xffffffffu;
    int owner = shown ? int(span.x) : 0;
    TexelMapping map = texel_mapping(owner);
    ivec2 place = texel + tile_origin;
    real3 start = texel_point(map, ivec2(int(span.y), place.y));
    line = TexelLine(start, map.step, map.down, real(place.x - int(span.y)), real(int(span.z)), owner);
    return shown;
}

// The point at an offset from the texel's centre, in texels.
real3 line_point(TexelLine line, real2 offset) {
    exact real3 point = line.start + (line.column + offset.x) * line.step + offset.y * line.down;
    return point;
}

// The point of texel x of the line; x need not be a whole number.
real3 point_on(TexelLine line, real x) {
    exact real3 point = line.start + x * line.step;
    return point;
}

// The linear map with columns x, y and z, applied to v.
real3 along(real3 x, real3 y, real3 z, real3 v) {
    exact real3 sum = x * v.x + y * v.y + z * v.z;
    return sum;
}

// The line mapped by the affine map with columns x, y and z and an offset.
TexelLine mapped(TexelLine line, real3 x, real3 y, real3 z, real3 offset) {
    exact real3 start = along(x, y, z, line.start) + offset;
    return TexelLine(start, along(x, y, z, line.step), along(x, y, z, line.down), line.column, line.count, line.owner);
}
