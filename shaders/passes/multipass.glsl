// The common part of the passes of multipass noise (procedural/passes/plan.h): texels of images to
// numbers and back. FIXED8 is 1 where images are RGBA8: then numbers are whole, 0 to 255, and
// stored ones are rounded to the nearest; otherwise 0.
uniform sampler2D first, second;
uniform usampler2D first_integers, map_cells, map_places;
uniform int doublings, axis;
uniform bool upper;
uniform uvec3 base_cell;
uniform uint integer_bits, cell_mask;

ivec2 texel() {
    return ivec2(gl_FragCoord.xy);
}

#if FIXED8
const float one = 255.0;

vec4 numbers(sampler2D image) {
    return floor(texelFetch(image, texel(), 0) * 255.0 + 0.5);
}
vec4 stored(vec4 x) {
    return clamp(floor(x + 0.5), 0.0, 255.0) / 255.0;
}
vec4 product(vec4 a, vec4 b) {
    return a * b / 255.0;
}
// The lattice coordinates, `step` cells up, of an image whose coordinates count from base_cell.
uvec3 lattice_cells(uint step) {
    uvec3 cells = uvec3(numbers(first).xyz) + step;
    return (cells & cell_mask) + base_cell;
}
#else
const float one = 1.0;

vec4 numbers(sampler2D image) {
    return texelFetch(image, texel(), 0);
}
vec4 stored(vec4 x) {
    return x;
}
vec4 product(vec4 a, vec4 b) {
    return a * b;
}
uvec3 lattice_cells(uint step) {
    return texelFetch(first_integers, texel(), 0).xyz + step;
}
#endif

// The cells of the lattice map after doublings.
uvec3 cells() {
    uvec3 cells = texelFetch(map_cells, texel(), 0).xyz;
    if (doublings == 0) return cells;
    return cells << doublings | texelFetch(map_places, texel(), 0).xyz >> (32 - doublings);
}
// The places of the lattice map after doublings, in units of 2^-32 cells.
uvec3 places() {
    return texelFetch(map_places, texel(), 0).xyz << doublings;
}
