// Sums of octaves of simplex noises with their gradients, over the footprint of two steps, as in
// procedural/graph/dual_simplex.cpp. This part must follow graph/dual.glsl and
// noise/simplex_signal.glsl.

struct DualVector {
    real4 x, y, z;
};

// The point of octave frequency: the first three coordinates times the frequency.
real4_item[8] octave_point(real4_item p[8], real frequency) {
    real4_item q[8] = p;
    for (int i = 0; i < 3; ++i) {
        exact real4 scaled = frequency * from_item(p[i]);
        q[i] = to_item(scaled);
    }
    return q;
}

// The share of an octave that shows where its point moves so far across the footprint; `fineness`
// is the number of cells to a unit.
real octave_share(int axes, real4_item p[8], real3 step_u, real3 step_v, real fineness) {
    exact real u = real(0.0), v = real(0.0);
    for (int i = 0; i < axes; ++i) {
        real3 slope = from_item(p[i]).yzw;
        real along_u = dot_of(slope, step_u), along_v = dot_of(slope, step_v);
        u = u + along_u * along_u;
        v = v + along_v * along_v;
    }
    exact real moved = fineness * max(nearest_root(u), nearest_root(v));
    if (!(moved > real(0.0))) return real(1.0);
    exact real kept = real(-1.0) - binary_log(moved);
    exact real away = (kept - real(3.0) / real(10.0)) * real(2.5);
    real w = min(max(away, real(0.0)), real(1.0));
    exact real share = w * w * (real(3.0) - real(2.0) * w);
    return share;
}

real4 dual_simplex_octaves(SimplexNoise noise, OctaveLadder ladder, real fineness, real4_item p[8],
                           real3 step_u, real3 step_v) {
    int axes = noise.lattice.axes;
    exact real4 total = real4(0.0);
    exact real frequency = real(1.0), weight = ladder.amplitude;
    for (int k = 0; k < ladder.octaves; ++k) {
        real4_item q[8] = octave_point(p, frequency);
        real share = octave_share(axes, q, step_u, step_v, fineness);
        if (share > real(0.0)) {
            real_item at[8];
            for (int i = 0; i < 8; ++i) at[i] = to_item(from_item(q[i]).x);
            SimplexSample n = simplex_sample(noise, ladder.seed + uint(k), at);
            exact real3 slope = real3(0.0);
            for (int i = 0; i < axes; ++i) slope = slope + real(n.slope[i]) * from_item(q[i]).yzw;
            exact real shown = weight * share;
            total = total + shown * real4(real(n.value), slope);
        }
        frequency = frequency * ladder.lacunarity;
        weight = weight * ladder.gain;
    }
    return total;
}

// A component of a field as a dual, from its gradient in the lattice.
real4 field_component(float value, vec3 gradient, real4 x, real4 y, real4 z) {
    exact real3 slope = real(gradient.x) * x.yzw + real(gradient.y) * y.yzw +
                        real(gradient.z) * z.yzw;
    return real4(real(value), slope);
}

DualVector dual_curl_octaves(SimplexLattice lattice, OctaveLadder ladder, real time, real4_item p[8],
                             real3 step_u, real3 step_v) {
    exact real4 x = real4(0.0), y = real4(0.0), z = real4(0.0);
    exact real frequency = real(1.0), weight = ladder.amplitude;
    for (int k = 0; k < ladder.octaves; ++k) {
        real4_item all[8] = octave_point(p, frequency);
        real share = octave_share(3, all, step_u, step_v, real(1.0));
        if (share > real(0.0)) {
            real4 a = from_item(all[0]), b = from_item(all[1]), c = from_item(all[2]);
            CurlSample n =
                curl_sample(lattice, ladder.seed + uint(k), real3(a.x, b.x, c.x), time);
            exact real shown = weight * share;
            x = x + shown * field_component(n.value.x, n.slope_x, a, b, c);
            y = y + shown * field_component(n.value.y, n.slope_y, a, b, c);
            z = z + shown * field_component(n.value.z, n.slope_z, a, b, c);
        }
        frequency = frequency * ladder.lacunarity;
        weight = weight * ladder.gain;
    }
    return DualVector(x, y, z);
}
