// Perlin's improved noise with its gradient, from the lattice hash. This part must follow
// noise/perlin.glsl and noise/gradient.glsl.

// The slope of a number below 16 at offset d, and its gradient.
vec4 perlin_corner_sample(uint number, vec3 d) {
    float a = negated_if(number, 1.0), b = negated_if(number >> 1, 1.0);
    bool b_on_y = number < 4u, b_on_x = (number & 13u) == 12u;
    vec3 g = number < 8u ? vec3(a, b_on_y ? b : 0.0, b_on_y ? 0.0 : b)
                         : vec3(b_on_x ? b : 0.0, a, b_on_x ? 0.0 : b);
    return vec4(perlin_slope(number, d), g);
}
// The slope of a number below 32 at offset d, and its gradient without the last component.
vec4 perlin_corner_sample(uint number, vec4 d) {
    uint without = number >> 3;
    float a = negated_if(number, 1.0), b = negated_if(number >> 1, 1.0),
          c = negated_if(number >> 2, 1.0);
    vec3 g = without == 0u   ? vec3(0.0, a, b)
             : without == 1u ? vec3(a, 0.0, b)
             : without == 2u ? vec3(a, b, 0.0)
                             : vec3(a, b, c);
    return vec4(perlin_slope(number, d), g);
}

// The samples at a square's corners, by their numbers, at x (low, high), y (low, high) and z.
mat4 perlin_samples(uvec4 number, vec2 x, vec2 y, float z) {
    return mat4(perlin_corner_sample(number.x, vec3(x.x, y.x, z)),
                perlin_corner_sample(number.y, vec3(x.y, y.x, z)),
                perlin_corner_sample(number.z, vec3(x.x, y.y, z)),
                perlin_corner_sample(number.w, vec3(x.y, y.y, z)));
}
mat4 perlin_samples(uvec4 number, vec2 x, vec2 y, vec2 zw) {
    return mat4(perlin_corner_sample(number.x, vec4(x.x, y.x, zw)),
                perlin_corner_sample(number.y, vec4(x.y, y.x, zw)),
                perlin_corner_sample(number.z, vec4(x.x, y.y, zw)),
                perlin_corner_sample(number.w, vec4(x.y, y.y, zw)));
}

// The gradient numbers of hashes before mixing: the upper bits of the mixed ones.
uvec4 hashed_numbers(uvec4 h, uint shift) {
    return uvec4(mix_bits(h.x), mix_bits(h.y), mix_bits(h.z), mix_bits(h.w)) >> shift;
}

vec4 perlin_sample(uint seed, uvec3 low, uvec3 high, vec3 place) {
    vec4 t = vec4(place + place, 0.0);
    vec3 a = place + 0.5, b = place - 0.5, v = quintic_fade(t).xyz,
         slope = quintic_fade_slope(t).xyz;
    uvec2 hx = uvec2(low.x, high.x) * prime_x + seed * prime_seed,
          hy = uvec2(low.y, high.y) * prime_y;
    uvec2 hz = uvec2(low.z, high.z) * prime_z;
    uvec4 xy = hx.xyxy + hy.xxyy;
    vec2 x = vec2(a.x, b.x), y = vec2(a.y, b.y);
    return twice_blend(v, slope, perlin_samples(hashed_numbers(xy + hz.x, 28u), x, y, a.z),
                       perlin_samples(hashed_numbers(xy + hz.y, 28u), x, y, b.z)) *
           0.125;
}

// Eight times the noise of a cube in four dimensions, at the fourth coordinate's hash and offset w.
vec4 perlin_cube_sample(uvec4 xy, uvec2 hz, vec2 x, vec2 y, vec2 z, float w, vec3 v, vec3 slope) {
    return twice_blend(v, slope,
                       perlin_samples(hashed_numbers(xy + hz.x, 27u), x, y, vec2(z.x, w)),
                       perlin_samples(hashed_numbers(xy + hz.y, 27u), x, y, vec2(z.y, w)));
}

vec4 perlin_sample(uint seed, uvec4 low, uvec4 high, vec4 place) {
    vec4 a = place + 0.5, b = place - 0.5, t = place + place, v = quintic_fade(t);
    vec3 slope = quintic_fade_slope(t).xyz;
    uvec2 hx = uvec2(low.x, high.x) * prime_x + seed * prime_seed,
          hy = uvec2(low.y, high.y) * prime_y;
    uvec2 hz = uvec2(low.z, high.z) * prime_z, hw = uvec2(low.w, high.w) * prime_w;
    uvec4 xy = hx.xyxy + hy.xxyy;
    vec2 x = vec2(a.x, b.x), y = vec2(a.y, b.y), z = vec2(a.z, b.z);
    return twice_blend(v.w, perlin_cube_sample(xy, hz + hw.x, x, y, z, a.w, v.xyz, slope),
                       perlin_cube_sample(xy, hz + hw.y, x, y, z, b.w, v.xyz, slope)) *
           0.0625;
}
