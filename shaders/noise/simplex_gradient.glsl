// Simplex noise with its gradient. This part must follow noise/simplex.glsl and
// noise/gradient.glsl.

// A corner's kernel t^4 (g . d) and its gradient t^4 g - 8 t^3 (g . d) d, t = radius2 - d . d.
vec4 simplex_kernel_sample(vec3 g, vec3 d, float radius2) {
    exact float t = radius2 - d.x * d.x - d.y * d.y - d.z * d.z;
    exact float slope = g.x * d.x + g.y * d.y + g.z * d.z;
    exact float t3 = t * t * t, t4 = t * t3;
    exact vec4 kernel = vec4(t4 * slope, t4 * g - (8.0 * t3 * slope) * d);
    return t < 0.0 ? vec4(0.0) : kernel;
}
// A corner's kernel in four dimensions and its gradient without the last component.
vec4 simplex_kernel_sample(vec4 g, vec4 d, float radius2) {
    exact float t = radius2 - d.x * d.x - d.y * d.y - d.z * d.z - d.w * d.w;
    exact float slope = g.x * d.x + g.y * d.y + g.z * d.z + g.w * d.w;
    exact float t3 = t * t * t, t4 = t * t3;
    exact vec4 kernel = vec4(t4 * slope, t4 * g.xyz - (8.0 * t3 * slope) * d.xyz);
    return t < 0.0 ? vec4(0.0) : kernel;
}

vec4 simplex_sample(uint seed, LatticeSite site, uvec3 period, float radius2) {
    SimplexWalk walk = simplex_walk(site);
    uvec3 shift = lattice_shift(seed);
    exact vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        sum += simplex_kernel_sample(walk_gradient(walk, period, shift), walk.offset, radius2);
        step_walk(walk, i);
    }
    return sum * 8.0;
}

vec4 simplex_sample(uint seed, LatticeSite site, real cell_w, real place_w) {
    HypercubeWalk walk = hypercube_walk(site, cell_w, place_w);
    exact vec4 sum = vec4(0.0);
    for (int i = 0; i < 5; ++i) {
        sum += simplex_kernel_sample(walk_gradient(walk, seed), walk.offset, 0.5);
        step_walk(walk, i);
    }
    return sum * 62.0;
}
