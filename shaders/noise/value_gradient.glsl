// Value noise with its gradient. This part must follow noise/value.glsl and noise/gradient.glsl.

// The samples at a square's corners, whose gradients are 0.
mat4 value_samples(uvec4 h) {
    vec4 n = value_corners(h);
    return mat4(vec4(n.x, 0.0, 0.0, 0.0), vec4(n.y, 0.0, 0.0, 0.0), vec4(n.z, 0.0, 0.0, 0.0),
                vec4(n.w, 0.0, 0.0, 0.0));
}

vec4 value_cube_sample(uvec4 xy, uvec2 z, vec3 v, vec3 slope) {
    return twice_blend(v, slope, value_samples(xy + z.x), value_samples(xy + z.y));
}

vec4 value_sample(uint seed, uvec3 low, uvec3 high, vec3 v, vec3 slope) {
    uvec2 x = uvec2(low.x, high.x) * prime_x + seed * prime_seed,
          y = uvec2(low.y, high.y) * prime_y;
    return value_cube_sample(x.xyxy + y.xxyy, uvec2(low.z, high.z) * prime_z, v, slope) *
           1.4901161193847656e-8;  // 2^-26
}

vec4 value_sample(uint seed, uvec4 low, uvec4 high, vec4 v, vec4 slope) {
    uvec2 x = uvec2(low.x, high.x) * prime_x + seed * prime_seed,
          y = uvec2(low.y, high.y) * prime_y;
    uvec2 z = uvec2(low.z, high.z) * prime_z, w = uvec2(low.w, high.w) * prime_w;
    uvec4 xy = x.xyxy + y.xxyy;
    return twice_blend(v.w, value_cube_sample(xy, z + w.x, v.xyz, slope.xyz),
                       value_cube_sample(xy, z + w.y, v.xyz, slope.xyz)) *
           7.450580596923828e-9;
}
