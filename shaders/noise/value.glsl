// Value noise (procedural/noise/value_noise.h, kernels/point_noise-inl.h): numbers at lattice
// points, interpolated with weights v from a fade. `low` and `high` are the coordinates of the
// cell's lower and upper lattice planes. This part must follow noise/lattice.glsl.

// 2^23 times the lattice values of hashes before mixing.
vec4 value_corners(uvec4 h) {
    return vec4(int(mix_bits(h.x)) >> 8, int(mix_bits(h.y)) >> 8, int(mix_bits(h.z)) >> 8,
                int(mix_bits(h.w)) >> 8);
}

// The noise of a cube times 8 * 2^23; its lower and upper planes have the hashes z.
float value_cube(uvec4 xy, uvec2 z, vec3 v) {
    return twice_lerp(v.z, twice_lerp(v.xy, value_corners(xy + z.x)),
                      twice_lerp(v.xy, value_corners(xy + z.y)));
}

float value_noise(uint seed, uvec3 low, uvec3 high, vec3 v) {
    uvec2 x = uvec2(low.x, high.x) * prime_x + seed * prime_seed,
          y = uvec2(low.y, high.y) * prime_y;
    return value_cube(x.xyxy + y.xxyy, uvec2(low.z, high.z) * prime_z, v) *
           1.4901161193847656e-8;  // 2^-26
}

float value_noise(uint seed, uvec4 low, uvec4 high, vec4 v) {
    uvec2 x = uvec2(low.x, high.x) * prime_x + seed * prime_seed,
          y = uvec2(low.y, high.y) * prime_y;
    uvec2 z = uvec2(low.z, high.z) * prime_z, w = uvec2(low.w, high.w) * prime_w;
    uvec4 xy = x.xyxy + y.xxyy;
    return twice_lerp(v.w, value_cube(xy, z + w.x, v.xyz), value_cube(xy, z + w.y, v.xyz)) *
           7.450580596923828e-9;
}
