// Perlin's noise of 1985 with its gradient. This part must follow noise/perlin1985.glsl and
// noise/gradient.glsl.

vec4 classic_sample(uint number, vec3 d) {
    vec3 g = classic_gradient(number);
    return vec4(exact_dot(g, d), g);
}
mat4 classic_samples(uvec4 number, vec2 x, vec2 y, float z) {
    return mat4(
        classic_sample(number.x, vec3(x.x, y.x, z)), classic_sample(number.y, vec3(x.y, y.x, z)),
        classic_sample(number.z, vec3(x.x, y.y, z)), classic_sample(number.w, vec3(x.y, y.y, z)));
}

vec4 perlin1985_sample(uint seed, uvec3 low, uvec3 high, vec3 place) {
    uvec3 shift = lattice_shift(seed);
    low += shift;
    high += shift;
    vec4 t = vec4(place + place, 0.0);
    vec3 a = place + 0.5, b = place - 0.5, v = smooth_fade(t).xyz,
         slope = smooth_fade_slope(t).xyz;
    uvec2 p = uvec2(classic_number(low.x), classic_number(high.x));
    uvec4 square = uvec4(classic_number(p.x + low.y), classic_number(p.y + low.y),
                         classic_number(p.x + high.y), classic_number(p.y + high.y));
    vec2 x = vec2(a.x, b.x), y = vec2(a.y, b.y);
    return twice_blend(v, slope, classic_samples(square + low.z, x, y, a.z),
                       classic_samples(square + high.z, x, y, b.z)) *
           0.125;
}
