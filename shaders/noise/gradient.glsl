// The common part of noises with gradients: a noise is a vec4 of its value and its derivatives
// along the lattice's x, y and z, blended and added up as in procedural/kernels/point_noise-inl.h,
// noise/interpolated_noise.h and kernels/noise_sum.cpp. This part must follow noise/lattice.glsl.

// The slopes of the fades v per cell, for t = twice the place.
vec4 linear_fade_slope(vec4 t) {
    return vec4(2.0);
}
vec4 smooth_fade_slope(vec4 t) {
    exact vec4 slope = 3.0 - 3.0 * (t * t);
    return slope;
}
vec4 quintic_fade_slope(vec4 t) {
    exact vec4 rest = 1.0 - t * t;
    exact vec4 slope = 3.75 * (rest * rest);
    return slope;
}

// Twice the blend of a and b; `slope` is the fade's slope, in the component of its axis.
vec4 twice_blend(float v, vec4 slope, vec4 a, vec4 b) {
    exact vec4 twice = ((a + b) + v * (b - a)) + slope * (b.x - a.x);
    return twice;
}
// Four times the blend of the corners 00, 10, 01 and 11 of a square.
vec4 twice_blend(vec3 v, vec3 slope, mat4 corners) {
    vec4 along_x = vec4(0.0, slope.x, 0.0, 0.0);
    return twice_blend(v.y, vec4(0.0, 0.0, slope.y, 0.0),
                       twice_blend(v.x, along_x, corners[0], corners[1]),
                       twice_blend(v.x, along_x, corners[2], corners[3]));
}
// Eight times the blend of a cube's lower and upper plane.
vec4 twice_blend(vec3 v, vec3 slope, mat4 low, mat4 high) {
    return twice_blend(v.z, vec4(0.0, 0.0, 0.0, slope.z), twice_blend(v, slope, low),
                       twice_blend(v, slope, high));
}
// Twice the blend along time, without a slope along it.
vec4 twice_blend(float v, vec4 a, vec4 b) {
    exact vec4 twice = (a + b) + v * (b - a);
    return twice;
}

// ---- Octaves: n, |n| or (1 - |n|)^2, of which `share` shows; the rest is its mean ----

// The share of octave k that shows where `kept` octaves are visible.
float visible_share(float kept, float k) {
    exact float u = min(max((kept - (k + 0.3)) * 2.5, 0.0), 1.0);
    exact float share = (u * u) * (3.0 - (u + u));
    return share;
}

// visible_share in `real`.
real visible_part(float kept, real k) {
    exact real away = (real(kept) - k - real(3.0) / real(10.0)) * real(2.5);
    exact real u = min(max(away, real(0.0)), real(1.0));
    exact real part = u * u * (real(3.0) - real(2.0) * u);
    return part;
}

// An octave at a split point, weighted in float32. `steepness` is weight times frequency.
vec4 weighed_octave(vec4 n, float shaped, float weight, float steepness, float share, float mean) {
    exact vec4 octave =
        vec4(weight * (share * shaped + (1.0 - share) * mean), steepness * n.yzw);
    return octave;
}
vec4 plain_octave(vec4 n, float weight, float steepness, float share, float mean) {
    return weighed_octave(n, n.x, weight, share * steepness, share, mean);
}
vec4 absolute_octave(vec4 n, float weight, float steepness, float share, float mean) {
    float turned = n.x < 0.0 ? -steepness : steepness;
    return weighed_octave(n, abs(n.x), weight, share * turned, share, mean);
}
vec4 ridged_octave(vec4 n, float weight, float steepness, float share, float mean) {
    exact float rest = 1.0 - abs(n.x), turned = share * (n.x < 0.0 ? -steepness : steepness);
    exact float ridge = turned * (-2.0 * rest);
    return weighed_octave(n, rest * rest, weight, ridge, share, mean);
}

// Octaves at sites are shaped in float32 and added up in `real`.
vec4 plain_sample(vec4 n) {
    return n;
}
vec4 absolute_sample(vec4 n) {
    return vec4(abs(n.x), sign(n.x) * n.yzw);
}
vec4 ridged_sample(vec4 n) {
    exact float rest = 1.0 - abs(n.x);
    exact vec4 ridge = vec4(rest * rest, (sign(n.x) * (-2.0 * rest)) * n.yzw);
    return ridge;
}
real4 add_octave(real4 sum, vec4 n, real weight, real frequency, real share, real mean) {
    exact real4 total = sum;
    total.x = total.x + weight * (real(1.0) - share) * mean;
    total.x = total.x + weight * share * real(n.x);
    total.yzw = total.yzw + (weight * share * frequency) * real3(n.yzw);
    return total;
}
