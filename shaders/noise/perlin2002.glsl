// Perlin's improved noise with the permutation that he published (procedural/noise/perlin_noise.h,
// kernels/point_noise-inl.h). This part must follow noise/perlin.glsl and the table `uint
// published_number(uint)`, which procedural/glsl/noise.cpp writes.

// The numbers of a square's four corners, to which the next coordinate is added.
uvec4 published_square(uvec2 x, uvec2 y) {
    uvec2 p = uvec2(published_number(x.x), published_number(x.y));
    return uvec4(published_number(p.x + y.x), published_number(p.y + y.x),
                 published_number(p.x + y.y), published_number(p.y + y.y));
}
uvec4 published_numbers(uvec4 h) {
    return uvec4(published_number(h.x), published_number(h.y), published_number(h.z),
                 published_number(h.w));
}

vec4 slopes_of(uvec4 number, vec2 x, vec2 y, float z) {
    number &= 15u;
    return vec4(
        perlin_slope(number.x, vec3(x.x, y.x, z)), perlin_slope(number.y, vec3(x.y, y.x, z)),
        perlin_slope(number.z, vec3(x.x, y.y, z)), perlin_slope(number.w, vec3(x.y, y.y, z)));
}
vec4 slopes_of(uvec4 number, vec2 x, vec2 y, vec2 zw) {
    number &= 31u;
    return vec4(
        perlin_slope(number.x, vec4(x.x, y.x, zw)), perlin_slope(number.y, vec4(x.y, y.x, zw)),
        perlin_slope(number.z, vec4(x.x, y.y, zw)), perlin_slope(number.w, vec4(x.y, y.y, zw)));
}

float perlin2002_noise(uint seed, uvec3 low, uvec3 high, vec3 place) {
    uvec3 shift = lattice_shift(seed);
    low += shift;
    high += shift;
    vec3 a = place + 0.5, b = place - 0.5, v = quintic_fade(vec4(place + place, 0.0)).xyz;
    uvec4 square = published_square(uvec2(low.x, high.x), uvec2(low.y, high.y));
    vec2 x = vec2(a.x, b.x), y = vec2(a.y, b.y);
    return twice_lerp(v.z,
                      twice_lerp(v.xy, slopes_of(published_numbers(square + low.z), x, y, a.z)),
                      twice_lerp(v.xy, slopes_of(published_numbers(square + high.z), x, y, b.z))) *
           0.125;
}

// Four times the noise of a square in four dimensions.
float perlin2002_square(uvec4 numbers, uint w, vec2 x, vec2 y, vec2 zw, vec2 v) {
    return twice_lerp(v, slopes_of(published_numbers(numbers + w), x, y, zw));
}

float perlin2002_noise(uint seed, uvec4 low, uvec4 high, vec4 place) {
    uvec4 shift = uvec4(lattice_shift(seed), lattice_shift_w(seed));
    low += shift;
    high += shift;
    vec4 a = place + 0.5, b = place - 0.5, v = quintic_fade(place + place);
    uvec4 square = published_square(uvec2(low.x, high.x), uvec2(low.y, high.y));
    uvec4 lower = published_numbers(square + low.z), upper = published_numbers(square + high.z);
    vec2 x = vec2(a.x, b.x), y = vec2(a.y, b.y);
    float before = twice_lerp(v.z, perlin2002_square(lower, low.w, x, y, vec2(a.z, a.w), v.xy),
                              perlin2002_square(upper, low.w, x, y, vec2(b.z, a.w), v.xy));
    float after = twice_lerp(v.z, perlin2002_square(lower, high.w, x, y, vec2(a.z, b.w), v.xy),
                             perlin2002_square(upper, high.w, x, y, vec2(b.z, b.w), v.xy));
    return twice_lerp(v.w, before, after) * 0.0625;
}
