// Simplex noise in two to eight dimensions with a signal of choice, and the curl of a simplex noise
// of vectors, as in procedural/noise/simplex_signal.h and simplex_curl.h. The simplex is found in
// `real`, the kernels are added in float32, octaves in `real`. This part must follow
// noise/lattice.glsl and numbers/elementary.glsl.

struct SimplexLattice {
    int axes;
    real stretch;  // sqrt(axes + 1)
    float unskew;  // (1 - 1 / stretch) / axes
    float unit;    // size of a random direction's components
};
struct SimplexNoise {
    SimplexLattice lattice;
    int signal;  // 0: a ramp, 1: a number, 2: a wave
    real turn;   // of a wave, in radians per unit
};
// Octave k has seed + k, frequency lacunarity^k and weight amplitude gain^k.
struct OctaveLadder {
    uint seed;
    int octaves;
    real lacunarity, gain, amplitude;
};
struct SimplexSample {
    float value;
    float slope[8];
};

// A corner of the simplex that holds a point: its skewed coordinates, the point's offset from it,
// and for each axis its place in the walk from the lowest corner to the highest, in which the
// largest offset comes first.
struct SimplexCorner {
    real_item index[8];
    float offset[8];
    int rank[8];
};

SimplexCorner lowest_corner(SimplexLattice lattice, real_item p[8]) {
    int axes = lattice.axes;
    bool thirds = axes == 3;
    exact real skew = (lattice.stretch - real(1.0)) / real(axes);
    real_item cell[8], offset[8];
    exact real cells = real(0.0), fractions = real(0.0);
    for (int i = 0; i < axes; ++i) {
        real whole_cell, place;
        site_along(from_item(p[i]), 0u, whole_cell, place);
        exact real fraction = place + real(0.5);
        cell[i] = to_item(whole_cell);
        offset[i] = to_item(fraction);
        cells = cells + whole_cell;
        fractions = fractions + fraction;
    }
    exact real product = skew * cells;
    exact real rest = product - floor(product), whole = floor(product);
    real rest3 = whole_remainder(cells, real(3.0));
    if (thirds) {
        rest = rest3 / real(3.0);
        whole = (cells - rest3) / real(3.0);
    }
    SimplexCorner corner;
    exact real steps = real(0.0);
    for (int i = 0; i < axes; ++i) {
        real fraction = from_item(offset[i]);
        exact real in_thirds = (real(3.0) * fraction + fractions + rest3) / real(3.0);
        exact real skewed = fraction + (rest + skew * fractions);
        real steps_of_axis = floor(thirds ? in_thirds : skewed);
        exact real index = from_item(cell[i]) + whole + steps_of_axis;
        exact real left = fraction - steps_of_axis;
        corner.index[i] = to_item(index);
        offset[i] = to_item(left);
        steps = steps + steps_of_axis;
    }
    exact real back = rest / lattice.stretch + skew / lattice.stretch * steps;
    for (int i = 0; i < axes; ++i) {
        exact real moved = from_item(offset[i]) + back;
        offset[i] = to_item(moved);
        corner.offset[i] = float(moved);
    }
    for (int i = 0; i < axes; ++i) {
        corner.rank[i] = 0;
        real here = from_item(offset[i]);
        for (int j = 0; j < axes; ++j) {
            real there = from_item(offset[j]);
            if (there > here || (there == here && j < i)) ++corner.rank[i];
        }
    }
    return corner;
}

// Takes step k of the walk to the next corner.
void step_corner(SimplexLattice lattice, int k, inout SimplexCorner corner) {
    for (int i = 0; i < lattice.axes; ++i) {
        bool along = corner.rank[i] == k;
        exact float offset = corner.offset[i] + lattice.unskew;
        exact float nearer = offset - 1.0;
        corner.offset[i] = along ? nearer : offset;
        if (along) corner.index[i] = to_item(from_item(corner.index[i]) + real(1.0));
    }
}

// Random bits of a lattice point; from the fifth coordinate on, those of the first four are the
// seed.
uint simplex_bits(int axes, real_item index[8], uint seed) {
    const uint primes[4] = uint[4](prime_x, prime_y, prime_z, prime_w);
    uint h = seed * prime_seed;
    for (int i = 0; i < axes; ++i) {
        if (i == 4) h = mix_bits(h) * prime_seed;
        h += low_bits_of_sum(from_item(index[i])) * primes[i & 3];
    }
    return mix_bits(h);
}

// The unit vector of random bits: one component is 0, the others have one size; in two dimensions
// the diagonals besides.
float[8] simplex_direction(int axes, float unit, uint bits) {
    uint choices = axes == 2 ? 4u : uint(axes);
    int choice = int((bits >> 8 & 0xffffu) * choices >> 16);
    float size = choice < axes ? unit : 0.70710678118654752;
    float g[8];
    for (int i = 0; i < axes; ++i)
        g[i] = i == choice ? 0.0 : (bits >> (31 - i) & 1u) != 0u ? size : -size;
    return g;
}

// The signal of a corner and its derivative, `along` being the component of the offset along the
// corner's direction.
vec2 simplex_signal(SimplexNoise noise, uint bits, float along) {
    if (noise.signal == 0) return vec2(along, 1.0);
    if (noise.signal == 1) return vec2(lattice_value(bits), 0.0);
    exact real phase = noise.turn * real(along);
    exact real steepness = noise.turn * cosine(phase);
    return vec2(float(sine(phase)), float(steepness));
}

void add_signal(SimplexNoise noise, uint bits, float d[8], inout SimplexSample sum) {
    int axes = noise.lattice.axes;
    float g[8] = simplex_direction(axes, noise.lattice.unit, bits);
    exact float t = 0.5, along = 0.0;
    for (int i = 0; i < axes; ++i) {
        exact float square = d[i] * d[i], product = g[i] * d[i];
        t = t - square;
        along = along + product;
    }
    if (t < 0.0) return;
    vec2 s = simplex_signal(noise, bits, along);
    exact float t3 = t * t * t, t4 = t * t3;
    exact float share = t4 * s.x;
    exact float value = sum.value + share;
    sum.value = value;
    for (int i = 0; i < axes; ++i) {
        exact float rise = t4 * s.y * g[i], fall = 8.0 * t3 * s.x * d[i];
        exact float slope = sum.slope[i] + (rise - fall);
        sum.slope[i] = slope;
    }
}

// The noise divided by its amplitude, with its gradient.
SimplexSample simplex_sample(SimplexNoise noise, uint seed, real_item p[8]) {
    SimplexLattice lattice = noise.lattice;
    SimplexCorner corner = lowest_corner(lattice, p);
    SimplexSample sum = SimplexSample(0.0, float[8](0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0));
    for (int k = 0; k <= lattice.axes; ++k) {
        add_signal(noise, simplex_bits(lattice.axes, corner.index, seed), corner.offset, sum);
        if (k < lattice.axes) step_corner(lattice, k, corner);
    }
    return sum;
}

// The sum of octaves; the frequency of the first three coordinates rises.
real simplex_octaves(SimplexNoise noise, OctaveLadder ladder, real_item p[8]) {
    exact real total = real(0.0), frequency = real(1.0), weight = ladder.amplitude;
    for (int k = 0; k < ladder.octaves; ++k) {
        real_item q[8] = p;
        for (int i = 0; i < 3; ++i) {
            exact real scaled = frequency * from_item(p[i]);
            q[i] = to_item(scaled);
        }
        exact real octave = weight * real(simplex_sample(noise, ladder.seed + uint(k), q).value);
        total = total + octave;
        frequency = frequency * ladder.lacunarity;
        weight = weight * ladder.gain;
    }
    return total;
}

// ---- Curl: a field with the gradients of its components ----

struct CurlSample {
    vec3 value, slope_x, slope_y, slope_z;
};

void add_vortex(int axes, uint bits, float offset[8], inout CurlSample sum) {
    exact float t = 0.5;
    for (int i = 0; i < axes; ++i) t = t - offset[i] * offset[i];
    if (t < 0.0) return;
    float r[8] = simplex_direction(3, 0.70710678118654752, bits);
    vec3 d = vec3(offset[0], offset[1], offset[2]);
    exact vec3 m = vec3(d.y * r[2] - d.z * r[1], d.z * r[0] - d.x * r[2], d.x * r[1] - d.y * r[0]);
    exact float t2 = t * t, bend = 48.0 * t2, pull = 8.0 * (t2 * t);
    exact vec3 value = sum.value - pull * m;
    exact vec3 x = sum.slope_x + (bend * d * m.x - pull * vec3(0.0, r[2], -r[1]));
    exact vec3 y = sum.slope_y + (bend * d * m.y - pull * vec3(-r[2], 0.0, r[0]));
    exact vec3 z = sum.slope_z + (bend * d * m.z - pull * vec3(r[1], -r[0], 0.0));
    sum = CurlSample(value, x, y, z);
}

// The field at a point, and at a time where the lattice has four axes, divided by its amplitude.
CurlSample curl_sample(SimplexLattice lattice, uint seed, real3 p, real time) {
    SimplexCorner corner = lowest_corner(
        lattice,
        real_item[8](to_item(p.x), to_item(p.y), to_item(p.z), to_item(time), to_item(real(0.0)),
                  to_item(real(0.0)), to_item(real(0.0)), to_item(real(0.0))));
    CurlSample sum = CurlSample(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    for (int k = 0; k <= lattice.axes; ++k) {
        add_vortex(lattice.axes, simplex_bits(lattice.axes, corner.index, seed), corner.offset, sum);
        if (k < lattice.axes) step_corner(lattice, k, corner);
    }
    return sum;
}

real3 curl_octaves(SimplexLattice lattice, OctaveLadder ladder, real time, real3 p) {
    exact real3 total = real3(0.0);
    exact real frequency = real(1.0), weight = ladder.amplitude;
    for (int k = 0; k < ladder.octaves; ++k) {
        exact real3 q = frequency * p;
        vec3 field = curl_sample(lattice, ladder.seed + uint(k), q, time).value;
        total = total + weight * real3(field);
        frequency = frequency * ladder.lacunarity;
        weight = weight * ladder.gain;
    }
    return total;
}
