// Perlin's improved noise with its gradient, from the permutation that he published. This part must
// follow noise/perlin2002.glsl and noise/perlin_gradient.glsl.

mat4 published_samples(uvec4 h, vec2 x, vec2 y, float z) {
    return perlin_samples(published_numbers(h) & 15u, x, y, z);
}
mat4 published_samples(uvec4 h, vec2 x, vec2 y, vec2 zw) {
    return perlin_samples(published_numbers(h) & 31u, x, y, zw);
}

vec4 perlin2002_sample(uint seed, uvec3 low, uvec3 high, vec3 place) {
    uvec3 shift = lattice_shift(seed);
    low += shift;
    high += shift;
    vec4 t = vec4(place + place, 0.0);
    vec3 a = place + 0.5, b = place - 0.5, v = quintic_fade(t).xyz,
         slope = quintic_fade_slope(t).xyz;
    uvec4 square = published_square(uvec2(low.x, high.x), uvec2(low.y, high.y));
    vec2 x = vec2(a.x, b.x), y = vec2(a.y, b.y);
    return twice_blend(v, slope, published_samples(square + low.z, x, y, a.z),
                       published_samples(square + high.z, x, y, b.z)) *
           0.125;
}

vec4 perlin2002_sample(uint seed, uvec4 low, uvec4 high, vec4 place) {
    uvec4 shift = uvec4(lattice_shift(seed), lattice_shift_w(seed));
    low += shift;
    high += shift;
    vec4 a = place + 0.5, b = place - 0.5, t = place + place, v = quintic_fade(t);
    vec3 slope = quintic_fade_slope(t).xyz;
    uvec4 square = published_square(uvec2(low.x, high.x), uvec2(low.y, high.y));
    uvec4 lower = published_numbers(square + low.z), upper = published_numbers(square + high.z);
    vec2 x = vec2(a.x, b.x), y = vec2(a.y, b.y);
    vec4 before =
        twice_blend(v.xyz, slope, published_samples(lower + low.w, x, y, vec2(a.z, a.w)),
                    published_samples(upper + low.w, x, y, vec2(b.z, a.w)));
    vec4 after =
        twice_blend(v.xyz, slope, published_samples(lower + high.w, x, y, vec2(a.z, b.w)),
                    published_samples(upper + high.w, x, y, vec2(b.z, b.w)));
    return twice_blend(v.w, before, after) * 0.0625;
}
