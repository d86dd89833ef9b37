// The noises of noise/stream_noise.glsl with their gradients in the octave's own lattice, as in
// procedural/kernels/noise_gradient-inl.h and simplex_kernel.cpp, to the bit: the noise and its
// derivatives along x, y and z, all divided by stream_unit. This part must follow
// noise/stream_noise.glsl.

// The slopes of the fades per cell, from centred_places.
vec3 fade_slope_linear(vec3 s) {
    return vec3(2.0);
}
vec3 fade_slope_smooth(vec3 s) {
    vec3 t = twice_places(s);
    exact vec3 slope = 1.5 - 1.5 * (t * t);
    return slope + slope;
}
vec3 fade_slope_quintic(vec3 s) {
    vec3 t = twice_places(s);
    exact vec3 rest = 1.0 - t * t;
    exact vec3 slope = 1.875 * (rest * rest);
    return slope + slope;
}

// ---- Value noise ----

// The coefficients of 1, v_x, v_y and v_x v_y in four times a plane's interpolation.
vec4 value_coefficients(uint h) {
    vec4 n = vec4(ivec4(plane_hashes(h) & 0xffffff00u));
    float low = n.x + n.y, high = n.z + n.w, low_x = n.y - n.x, high_x = n.w - n.z;
    exact vec4 coefficients = vec4(low + high, low_x + high_x, high - low, high_x - low_x);
    return coefficients;
}

float value_at(vec4 plane, vec3 fade) {
    exact float n = (plane.x + fade.x * plane.y) + fade.y * (plane.z + fade.x * plane.w);
    return n;
}

vec4 stream_value_gradient(StreamSite site, uint seed, vec3 fade, vec3 slope) {
    uint h = cell_hash(site.cell, seed);
    vec4 low = value_coefficients(h), high = value_coefficients(h + prime_z);
    float below = value_at(low, fade), above = value_at(high, fade);
    exact vec2 along_x = vec2(low.y, high.y) + fade.y * vec2(low.w, high.w);
    exact vec2 along_y = vec2(low.z, high.z) + fade.x * vec2(low.w, high.w);
    exact vec3 gradient = slope * vec3(twice_lerp(fade.z, along_x.x, along_x.y),
                                       twice_lerp(fade.z, along_y.x, along_y.y), above - below);
    return vec4(twice_lerp(fade.z, below, above), gradient);
}
vec4 stream_value_linear_gradient(StreamSite site, uint seed) {
    vec3 s = centred_places(site.place);
    return stream_value_gradient(site, seed, stream_fade_linear(s), fade_slope_linear(s));
}
vec4 stream_value_smooth_gradient(StreamSite site, uint seed) {
    vec3 s = centred_places(site.place);
    return stream_value_gradient(site, seed, stream_fade_smooth(s), fade_slope_smooth(s));
}
vec4 stream_value_quintic_gradient(StreamSite site, uint seed) {
    vec3 s = centred_places(site.place);
    return stream_value_gradient(site, seed, stream_fade_quintic(s), fade_slope_quintic(s));
}

// ---- Perlin noise ----

// The gradient whose number is in the upper four bits of h.
vec3 perlin_gradient(uint h) {
    uint number = h >> 28;
    float a = with_sign(1.0, h << 3), b = with_sign(1.0, h << 2);
    bool first_is_y = number >= 8u, second_is_x = number == 12u || number == 14u;
    return vec3(first_is_y ? (second_is_x ? b : 0.0) : a, first_is_y ? a : (number < 4u ? b : 0.0),
                number < 4u || second_is_x ? 0.0 : b);
}

// Four times a plane's interpolation, and its derivatives by the fades along x and y. `weight` is
// the plane's; the corners' weighted gradients are added to `own`.
vec3 perlin_plane_gradient(uint h, vec3 t, float z, vec3 fade, float weight, inout vec3 own) {
    uvec4 hash = plane_hashes(h);
    float x0 = t.x + 1.0, x1 = t.x - 1.0, y0 = t.y + 1.0, y1 = t.y - 1.0;
    float a = perlin_corner(hash.x, x0, y0, z), b = perlin_corner(hash.y, x1, y0, z);
    float e = perlin_corner(hash.z, x0, y1, z), f = perlin_corner(hash.w, x1, y1, z);
    exact float low = weight * (1.0 - fade.y), high = weight * (1.0 + fade.y);
    exact float left = 1.0 - fade.x, right = 1.0 + fade.x;
    exact vec3 sum = own + perlin_gradient(hash.x) * (low * left);
    sum = sum + perlin_gradient(hash.y) * (low * right);
    sum = sum + perlin_gradient(hash.z) * (high * left);
    sum = sum + perlin_gradient(hash.w) * (high * right);
    own = sum;
    float at_low = twice_lerp(fade.x, a, b), at_high = twice_lerp(fade.x, e, f);
    exact float along_x = twice_lerp(fade.y, b - a, f - e), along_y = at_high - at_low;
    return vec3(twice_lerp(fade.y, at_low, at_high), along_x, along_y);
}

// Perlin noise with its gradient; `seed` is the octave's seed times prime_seed.
vec4 stream_perlin_gradient(StreamSite site, uint seed) {
    vec3 s = centred_places(site.place), fade = stream_fade_quintic(s), t = twice_places(s);
    uint h = cell_hash(site.cell, seed);
    vec3 own = vec3(0.0);
    vec3 below = perlin_plane_gradient(h, t, t.z + 1.0, fade, 1.0 - fade.z, own);
    vec3 above = perlin_plane_gradient(h + prime_z, t, t.z - 1.0, fade, 1.0 + fade.z, own);
    vec3 change = vec3(twice_lerp(fade.z, below.y, above.y), twice_lerp(fade.z, below.z, above.z),
                       above.x - below.x);
    // Twice the corners' gradients, because the slopes are taken at twice the distance.
    exact vec3 gradient = fade_slope_quintic(s) * change + (own + own);
    return vec4(twice_lerp(fade.z, below.x, above.x), gradient);
}

// ---- Simplex noise ----

vec4 stream_simplex_gradient(StreamSite site, uvec3 shift, float radius2) {
    SimplexCorners at = simplex_corners(site, shift);
    exact vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        vec3 g = simplex_gradient(pattern_hash(at.corner[i])), offset = at.offset[i];
        float t = simplex_height(offset, radius2), slope = exact_dot(g, offset);
        exact float t2 = t * t, t4 = t2 * t2;
        // d(t^4) / d(offset) is -8 t^3 offset.
        exact float fall = (8.0 * (t2 * t)) * slope;
        sum.x = sum.x + t4 * slope;
        sum.yzw = sum.yzw + (t4 * g - fall * offset);
    }
    return sum;
}
