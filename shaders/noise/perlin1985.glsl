// Perlin's noise of 1985 (procedural/noise/perlin1985.h, kernels/point_noise-inl.h). This part must
// follow noise/lattice.glsl and the tables `uint classic_number(uint)` and `vec3
// classic_gradient(uint)`, which procedural/glsl/noise.cpp writes.

float classic_slope(uint number, vec3 d) {
    return exact_dot(classic_gradient(number), d);
}
vec4 classic_slopes(uvec4 number, vec2 x, vec2 y, float z) {
    return vec4(
        classic_slope(number.x, vec3(x.x, y.x, z)), classic_slope(number.y, vec3(x.y, y.x, z)),
        classic_slope(number.z, vec3(x.x, y.y, z)), classic_slope(number.w, vec3(x.y, y.y, z)));
}

float perlin1985_noise(uint seed, uvec3 low, uvec3 high, vec3 place) {
    uvec3 shift = lattice_shift(seed);
    low += shift;
    high += shift;
    vec3 a = place + 0.5, b = place - 0.5, v = smooth_fade(vec4(place + place, 0.0)).xyz;
    uvec2 p = uvec2(classic_number(low.x), classic_number(high.x));
    uvec4 square = uvec4(classic_number(p.x + low.y), classic_number(p.y + low.y),
                         classic_number(p.x + high.y), classic_number(p.y + high.y));
    vec2 x = vec2(a.x, b.x), y = vec2(a.y, b.y);
    return twice_lerp(v.z, twice_lerp(v.xy, classic_slopes(square + low.z, x, y, a.z)),
                      twice_lerp(v.xy, classic_slopes(square + high.z, x, y, b.z))) *
           0.125;
}
