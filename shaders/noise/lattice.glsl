// The common part of noises on the lattice: hash, sites, periods and fades of
// procedural/numbers/lattice_hash.h, noise/lattice_site.h, kernels/point_sites-inl.h and
// kernels/noise_corners-inl.h, in their sequence of operations. This part must follow
// numbers/real.glsl.
//
// A point reaches a noise in one of two forms, as on the host:
// - split: split_points(p, limit), then cells_of(split, k) and places_of(split, k) after k
//   doublings: the cell modulo 2^32, and the place in it from its middle, in [-1/2, 1/2] (for sums
//   of interpolated noise without period and time);
// - as a site, lattice_site(p, period), period 0 being none, for all other noise.

const uint prime_x = 0x8da6b343u, prime_y = 0xd8163841u, prime_z = 0xcb1ab31fu,
           prime_w = 0xc2b2ae3du, prime_seed = 0x9e3779b1u;
const real lattice_limit = real(2251799813685248.0);  // 2^51

uint mix_bits(uint h) {
    h ^= h >> 16;
    h *= 0x7feb352du;
    h ^= h >> 15;
    return h * 0x846ca68bu;
}

// The shift in cells by which a seed moves a noise whose random numbers are a table of period 256.
uvec3 lattice_shift(uint seed) {
    if (seed == 0u) return uvec3(0u);
    uint h = seed * prime_seed;
    return uvec3(mix_bits(h), mix_bits(h + prime_x), mix_bits(h + 2u * prime_x)) >> 24;
}
uint lattice_shift_w(uint seed) {
    return seed == 0u ? 0u : mix_bits(seed * prime_seed + 3u * prime_x) >> 24;
}

// The lower 32 bits of a whole number, |whole| < 2^51.
uint low_bits(real whole) {
#if REAL_IS_DOUBLE
    exact double shifted = whole + 6755399441055744.0;  // 1.5 2^52
    return unpackDouble2x32(shifted).x;
#else
    return uint(int(whole));
#endif
}

// The lower 32 bits of a whole number, |whole| < 2^53.
uint low_bits_of_sum(real whole) {
#if REAL_IS_DOUBLE
    exact double rest = whole - 4294967296.0 * floor(whole * 2.3283064365386962890625e-10);
    return low_bits(rest);
#else
    return low_bits(whole);
#endif
}

// A whole number modulo n > 0, in [0, n).
real whole_remainder(real whole, real n) {
    exact real rest = whole - n * floor(whole / n);
    if (rest < real(0.0)) rest += n;
    if (rest >= n) rest -= n;
    return rest;
}

// ---- Split points ----

struct SplitPoint {
    uvec3 cell, part;  // upper and lower 32 bits, in units of 2^-32 cells
};

void split_coordinate(real x, real limit, out uint cell, out uint part) {
    real y = abs(x) < limit ? x : real(0.0);
    exact real from_middle = y - real(0.5);
    real whole = roundEven(from_middle);
    exact real place = from_middle - whole;
#if REAL_IS_DOUBLE
    exact double fixed_point = place + 1572864.0;  // 1.5 2^20: in units of 2^-32
    part = unpackDouble2x32(fixed_point).x + 0x80000000u;
#else
    part = uint(int(place * 2147483648.0)) * 2u + 0x80000000u;
#endif
    cell = low_bits(whole) + (part == 0u && place > real(0.0) ? 1u : 0u);
}

// The split of a point. Coordinates that reach `limit` count as 0; it is lattice_limit, halved for
// each of the doublings to come.
SplitPoint split_points(real3 p, real limit) {
    SplitPoint split;
    split_coordinate(p.x, limit, split.cell.x, split.part.x);
    split_coordinate(p.y, limit, split.cell.y, split.part.y);
    split_coordinate(p.z, limit, split.cell.z, split.part.z);
    return split;
}

// The cells after at most 31 doublings.
uvec3 cells_of(SplitPoint split, int doublings) {
    return split.cell << doublings | split.part >> 1 >> 31 - doublings;
}
// The places from the cells' middles after at most 31 doublings, in [-1/2, 1/2].
vec3 places_of(SplitPoint split, int doublings) {
    return vec3(ivec3(split.part << doublings ^ 0x80000000u)) *
           2.3283064365386962890625e-10;  // 2^-32
}

// ---- Sites ----

struct LatticeSite {
    real3 cell;   // whole numbers; within [0, period) if there is one
    real3 place;  // offset from the cell's middle, in [-1/2, 1/2]
};

void site_along(real x, uint period, out real cell, out real place) {
    real y = abs(x) < lattice_limit ? x : real(0.0);
    cell = floor(y);
    exact real fraction = y - cell;
    exact real centred = fraction - real(0.5);
    place = centred;
    if (period != 0u) cell = whole_remainder(cell, real(period));
}

LatticeSite lattice_site(real3 p, uvec3 period) {
    LatticeSite site;
    site_along(p.x, period.x, site.cell.x, site.place.x);
    site_along(p.y, period.y, site.cell.y, site.place.y);
    site_along(p.z, period.z, site.cell.z, site.place.z);
    return site;
}

uvec3 cell_bits(LatticeSite site) {
    return uvec3(low_bits(site.cell.x), low_bits(site.cell.y), low_bits(site.cell.z));
}

// The coordinate of the lattice point `steps` (-2 to 2) cells up, modulo the period if there is
// one.
uint lattice_index(uint cell, int steps, uint period) {
    uint i = cell + uint(steps);
    return period == 0u ? i : (i + 2u * period) % period;
}
uvec3 lattice_index(uvec3 cell, ivec3 steps, uvec3 period) {
    return uvec3(lattice_index(cell.x, steps.x, period.x), lattice_index(cell.y, steps.y, period.y),
                 lattice_index(cell.z, steps.z, period.z));
}
uvec4 lattice_index(uvec4 cell, ivec4 steps, uvec4 period) {
    return uvec4(lattice_index(cell.xyz, steps.xyz, period.xyz),
                 lattice_index(cell.w, steps.w, period.w));
}

uint lattice_bits(uvec3 index, uint seed) {
    return mix_bits(seed * prime_seed + index.x * prime_x + index.y * prime_y + index.z * prime_z);
}
uint lattice_bits(uvec4 index, uint seed) {
    return mix_bits(seed * prime_seed + index.x * prime_x + index.y * prime_y + index.z * prime_z +
                    index.w * prime_w);
}

// The hash's upper 24 bits as a number in [-1, 1).
float lattice_value(uint h) {
    return float(int(h) >> 8) * 1.1920928955078125e-7;  // 2^-23
}

// ---- Blending ----

// The weights v = 2 w - 1 in [-1, 1] for t = twice the place, by axis.
vec4 linear_fade(vec4 t) {
    return t;
}
vec4 smooth_fade(vec4 t) {
    exact vec4 v = t + t * (0.5 - 0.5 * (t * t));
    return v;
}
vec4 quintic_fade(vec4 t) {
    exact vec4 square = t * t;
    exact vec4 v = t + t * ((1.0 - square) * (0.875 - 0.375 * square));
    return v;
}

// Twice the interpolation between a and b.
float twice_lerp(float v, float a, float b) {
    exact float twice = (a + b) + v * (b - a);
    return twice;
}
// Four times the interpolation between the corners 00, 10, 01 and 11 of a square.
float twice_lerp(vec2 v, vec4 corners) {
    return twice_lerp(v.y, twice_lerp(v.x, corners.x, corners.y),
                      twice_lerp(v.x, corners.z, corners.w));
}

float exact_dot(vec3 a, vec3 b) {
    exact float sum = a.x * b.x + a.y * b.y + a.z * b.z;
    return sum;
}
