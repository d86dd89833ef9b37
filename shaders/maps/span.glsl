// A span of an atlas (atlas/solid/solid_atlas.h) as a quad one texel high, and the line of solid
// points that its texels show: every map of an atlas is drawn from these, one instance a span. All
// arithmetic is float64 with the host's operations in the host's order (`precise` keeps compilers
// from others), so that maps have the host's bits.
layout(location = 0) in uvec3 span;  // first column, number of texels, number of the triangle's map
layout(location = 1) in uint row;

uniform usamplerBuffer texel_maps;  // TexelMap as it lies in memory, five texels each
uniform ivec2 tile_origin, tile_size;

flat out int first_column;  // first column of the span in the tile
flat out uint owner;        // number of the triangle's map

struct SpanLine {
    dvec3 start, step;  // texel j of the span shows start + j step
};

// Places a corner of the span's strip of four vertices. Coordinates are whole texels, so that
// rounding moves no edge over a texel's centre.
void place_span() {
    ivec2 corner = ivec2(int(span.x) + (gl_VertexID & 1) * int(span.y), int(row) + (gl_VertexID >> 1)) - tile_origin;
    gl_Position = vec4(vec2(2 * corner - tile_size) / vec2(tile_size), 0.0, 1.0);
    first_column = int(span.x) - tile_origin.x;
    owner = span.z;
}

// The span's line, from TexelMap::operator() at its first texel.
SpanLine span_line() {
    int at = 5 * int(span.z);
    uvec4 m0 = texelFetch(texel_maps, at), m1 = texelFetch(texel_maps, at + 1), m2 = texelFetch(texel_maps, at + 2),
          m3 = texelFetch(texel_maps, at + 3), m4 = texelFetch(texel_maps, at + 4);
    dvec3 origin = dvec3(packDouble2x32(m0.xy), packDouble2x32(m0.zw), packDouble2x32(m1.xy));
    dvec3 step_x = dvec3(packDouble2x32(m1.zw), packDouble2x32(m2.xy), packDouble2x32(m2.zw));
    dvec3 step_y = dvec3(packDouble2x32(m3.xy), packDouble2x32(m3.zw), packDouble2x32(m4.xy));
    double across = double(int(span.x) - int(m4.z)), up = double(int(row) - int(m4.w));
    precise dvec3 start = origin + across * step_x + up * step_y;
    return SpanLine(start, step_x);
}

// The product m v, its terms added from the left.
dvec3 along(dmat3 m, dvec3 v) {
    precise dvec3 sum = m[0] * v.x + m[1] * v.y + m[2] * v.z;
    return sum;
}
double dot_product(dvec3 a, dvec3 b) {
    precise double sum = a.x * b.x + a.y * b.y + a.z * b.z;
    return sum;
}
