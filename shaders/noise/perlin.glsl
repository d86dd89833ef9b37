// Perlin's improved noise with gradient numbers from the lattice hash
// (procedural/noise/perlin_noise.h, kernels/point_noise-inl.h); quintic weights v. `low` and `high`
// are the coordinates of the cell's lower and upper lattice planes. This part must follow
// noise/lattice.glsl.

float negated_if(uint odd, float x) {
    return uintBitsToFloat(floatBitsToUint(x) ^ odd << 31);
}

// The height, at offset d, of the slope of a number below 16.
float perlin_slope(uint number, vec3 d) {
    float a = number < 8u ? d.x : d.y;
    float b = number < 4u ? d.y : (number & 13u) == 12u ? d.x : d.z;
    exact float height = negated_if(number, a) + negated_if(number >> 1, b);
    return height;
}
// The height, at offset d, of the slope of a number below 32.
float perlin_slope(uint number, vec4 d) {
    uint without = number >> 3;
    float a = without == 0u ? d.y : d.x, b = without < 2u ? d.z : d.y,
          c = without == 3u ? d.z : d.w;
    exact float height =
        negated_if(number, a) + negated_if(number >> 1, b) + negated_if(number >> 2, c);
    return height;
}

// The heights at a square's corners, from hashes before mixing, at x (low, high), y (low, high) and
// z.
vec4 perlin_corners(uvec4 h, vec2 x, vec2 y, float z) {
    return vec4(perlin_slope(mix_bits(h.x) >> 28, vec3(x.x, y.x, z)),
                perlin_slope(mix_bits(h.y) >> 28, vec3(x.y, y.x, z)),
                perlin_slope(mix_bits(h.z) >> 28, vec3(x.x, y.y, z)),
                perlin_slope(mix_bits(h.w) >> 28, vec3(x.y, y.y, z)));
}
// The heights at a square's corners in four dimensions, at x (low, high), y (low, high), z and w.
vec4 perlin_corners(uvec4 h, vec2 x, vec2 y, vec2 zw) {
    return vec4(perlin_slope(mix_bits(h.x) >> 27, vec4(x.x, y.x, zw)),
                perlin_slope(mix_bits(h.y) >> 27, vec4(x.y, y.x, zw)),
                perlin_slope(mix_bits(h.z) >> 27, vec4(x.x, y.y, zw)),
                perlin_slope(mix_bits(h.w) >> 27, vec4(x.y, y.y, zw)));
}

float perlin_noise(uint seed, uvec3 low, uvec3 high, vec3 place) {
    vec3 a = place + 0.5, b = place - 0.5, v = quintic_fade(vec4(place + place, 0.0)).xyz;
    uvec2 hx = uvec2(low.x, high.x) * prime_x + seed * prime_seed,
          hy = uvec2(low.y, high.y) * prime_y;
    uvec2 hz = uvec2(low.z, high.z) * prime_z;
    uvec4 xy = hx.xyxy + hy.xxyy;
    vec2 x = vec2(a.x, b.x), y = vec2(a.y, b.y);
    return twice_lerp(v.z, twice_lerp(v.xy, perlin_corners(xy + hz.x, x, y, a.z)),
                      twice_lerp(v.xy, perlin_corners(xy + hz.y, x, y, b.z))) *
           0.125;
}

// Eight times the noise of a cube in four dimensions, at the fourth coordinate's hash and offset w.
float perlin_cube(uvec4 xy, uvec2 hz, vec2 x, vec2 y, vec2 z, float w, vec3 v) {
    return twice_lerp(v.z, twice_lerp(v.xy, perlin_corners(xy + hz.x, x, y, vec2(z.x, w))),
                      twice_lerp(v.xy, perlin_corners(xy + hz.y, x, y, vec2(z.y, w))));
}

float perlin_noise(uint seed, uvec4 low, uvec4 high, vec4 place) {
    vec4 a = place + 0.5, b = place - 0.5, v = quintic_fade(place + place);
    uvec2 hx = uvec2(low.x, high.x) * prime_x + seed * prime_seed,
          hy = uvec2(low.y, high.y) * prime_y;
    uvec2 hz = uvec2(low.z, high.z) * prime_z, hw = uvec2(low.w, high.w) * prime_w;
    uvec4 xy = hx.xyxy + hy.xxyy;
    vec2 x = vec2(a.x, b.x), y = vec2(a.y, b.y), z = vec2(a.z, b.z);
    return twice_lerp(v.w, perlin_cube(xy, hz + hw.x, x, y, z, a.w, v.xyz),
                      perlin_cube(xy, hz + hw.y, x, y, z, b.w, v.xyz)) *
           0.0625;
}
