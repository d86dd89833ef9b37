// Simplex noise at points, in three dimensions (Perlin 2001, appendix B) and four
// (procedural/noise/simplex_noise.h). The simplex is found in `real`, the kernels are added in
// float32. This part must follow noise/lattice.glsl.

// The appendix's shuffle: the sum of eight patterns, each chosen by a bit of each coordinate; its
// lower six bits name a gradient.
uint bit_pattern_sum(uvec3 index) {
    // The bits that are first, second and third in the number of their pattern.
    uvec3 a = index & 0x49u, b = index & 0x92u, c = index & 0x24u;
    uint first = a.x | b.y | c.z, second = a.y | b.z | c.x, third = a.z | b.x | c.y;
    uint sum = 0u;
    for (int bit = 0; bit < 8; ++bit) {
        uint place = (second >> bit & 1u) << 4 | (third >> bit & 1u) << 3;
        sum += ((first >> bit & 1u) == 0u ? 0x2c323815u : 0x2a07130du) >> place & 255u;
    }
    return sum;
}

// The gradient that the sum's lower six bits name.
vec3 bit_pattern_gradient(uint h) {
    uint turn = h & 3u, b2 = h >> 2 & 1u, b3 = h >> 3 & 1u, b4 = h >> 4 & 1u, b5 = h >> 5 & 1u;
    float p = (b5 ^ b3) == 0u ? -1.0 : 1.0;
    float q = turn != 0u && b2 == 1u ? 0.0 : (b5 ^ b4) == 0u ? -1.0 : 1.0;
    float r = turn != 0u && b2 == 0u ? 0.0 : (b5 ^ b4 ^ b3) == 1u ? -1.0 : 1.0;
    return turn == 1u ? vec3(p, q, r) : turn == 2u ? vec3(r, p, q) : vec3(q, r, p);
}

// The gradient of a hash: the middle of an edge of a hypercube.
vec4 hypercube_gradient(uint h) {
    uint without = h & 3u;
    vec3 g = vec3((uvec3(h) >> uvec3(3u, 4u, 5u) & 1u)) * 2.0 - 1.0;
    return without == 0u   ? vec4(0.0, g)
           : without == 1u ? vec4(g.x, 0.0, g.yz)
           : without == 2u ? vec4(g.xy, 0.0, g.z)
                           : vec4(g, 0.0);
}

// A corner's kernel t^4 (g . d), t = radius2 - d . d.
float simplex_kernel(vec3 g, vec3 d, float radius2) {
    exact float t = radius2 - d.x * d.x - d.y * d.y - d.z * d.z;
    exact float slope = g.x * d.x + g.y * d.y + g.z * d.z;
    exact float kernel = (t * (t * t * t)) * slope;
    return t < 0.0 ? 0.0 : kernel;
}
float simplex_kernel(vec4 g, vec4 d, float radius2) {
    exact float t = radius2 - d.x * d.x - d.y * d.y - d.z * d.z - d.w * d.w;
    exact float slope = g.x * d.x + g.y * d.y + g.z * d.z + g.w * d.w;
    exact float kernel = (t * (t * t * t)) * slope;
    return t < 0.0 ? 0.0 : kernel;
}

// The number of the step, of the walk from the lowest corner to the highest, that goes along each
// axis: the largest offset comes first, of equal ones that along the lower axis.
ivec3 walk_order(real3 d) {
    int yx = int(d.y > d.x), zx = int(d.z > d.x), zy = int(d.z > d.y);
    return ivec3(yx + zx, 1 - yx + zy, 2 - zx - zy);
}
ivec4 walk_order(real4 d) {
    int wx = int(d.w > d.x), wy = int(d.w > d.y), wz = int(d.w > d.z);
    return ivec4(walk_order(d.xyz) + ivec3(wx, wy, wz), 3 - wx - wy - wz);
}

// A lattice point in skewed coordinates modulo the period.
uvec3 wrap_simplex(real3 corner, real3 period) {
    real sum = corner.x + corner.y + corner.z;
    corner = real(6.0) * corner - sum;
    corner = real3(whole_remainder(corner.x, real(6.0) * period.x),
                   whole_remainder(corner.y, real(6.0) * period.y),
                   whole_remainder(corner.z, real(6.0) * period.z));
    real third = (corner.x + corner.y + corner.z) / real(3.0);
    corner = (corner + third) / real(6.0);
    return uvec3(low_bits(corner.x), low_bits(corner.y), low_bits(corner.z));
}

// A corner of the simplex that holds a point: the lattice point in skewed coordinates, the point's
// offset from it, and the number of the step that goes along each axis.
struct SimplexWalk {
    real3 corner;
    vec3 offset;
    ivec3 order;
};

SimplexWalk simplex_walk(LatticeSite site) {
    real cells = site.cell.x + site.cell.y + site.cell.z;
    real rest = whole_remainder(cells, real(3.0)), whole = (cells - rest) / real(3.0);
    exact real3 fraction = site.place + real(0.5);
    exact real fractions = fraction.x + fraction.y + fraction.z;
    exact real3 skewed = (real(3.0) * fraction + fractions + rest) / real(3.0);
    real3 steps = floor(skewed);
    exact real back = rest / real(3.0) / real(2.0) +
                      real(1.0) / real(3.0) / real(2.0) * (steps.x + steps.y + steps.z);
    exact real3 offset = fraction - steps + back;
    return SimplexWalk(site.cell + whole + steps, vec3(offset), walk_order(offset));
}

// Takes step i of the walk to the next corner.
void step_walk(inout SimplexWalk walk, int i) {
    vec3 along = vec3(equal(walk.order, ivec3(i)));
    walk.corner += real3(along);
    exact vec3 offset = (walk.offset + 0.16666667163372039794921875) - along;  // 1/6
    walk.offset = offset;
}

// The gradient of the walk's corner. `period` is a multiple of 3 on each axis: 768, after which the
// hash repeats, for noise without a period. The site must lie within it.
vec3 walk_gradient(SimplexWalk walk, uvec3 period, uvec3 shift) {
    uvec3 index = wrap_simplex(walk.corner, real3(period)) + shift;
    return bit_pattern_gradient(bit_pattern_sum(index));
}

float simplex_noise(uint seed, LatticeSite site, uvec3 period, float radius2) {
    SimplexWalk walk = simplex_walk(site);
    uvec3 shift = lattice_shift(seed);
    exact float sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        sum += simplex_kernel(walk_gradient(walk, period, shift), walk.offset, radius2);
        step_walk(walk, i);
    }
    return sum * 8.0;
}

#if REAL_IS_DOUBLE
const double hypercube_stretch = 2.2360679774997896LF;  // sqrt 5
#else
const float hypercube_stretch = 2.2360679774997896;
#endif

// A corner of the simplex that holds a point in four dimensions, as SimplexWalk.
struct HypercubeWalk {
    real4 corner;
    vec4 offset;
    ivec4 order;
};

HypercubeWalk hypercube_walk(LatticeSite site, real cell_w, real place_w) {
    real4 cell = real4(site.cell, cell_w);
    const real skew = (hypercube_stretch - real(1.0)) / real(4.0);
    exact real product = skew * (cell.x + cell.y + cell.z + cell.w);
    real whole = floor(product);
    exact real rest = product - whole;
    exact real4 fraction = real4(site.place, place_w) + real(0.5);
    exact real fractions = fraction.x + fraction.y + fraction.z + fraction.w;
    exact real4 skewed = fraction + (rest + skew * fractions);
    real4 steps = floor(skewed);
    exact real back = rest / hypercube_stretch +
                      skew / hypercube_stretch * (steps.x + steps.y + steps.z + steps.w);
    exact real4 offset = fraction - steps + back;
    return HypercubeWalk(cell + whole + steps, vec4(offset), walk_order(offset));
}

void step_walk(inout HypercubeWalk walk, int i) {
    vec4 along = vec4(equal(walk.order, ivec4(i)));
    walk.corner += real4(along);
    exact vec4 offset = (walk.offset + 0.138196601125010515) - along;  // (1 - 1 / sqrt 5) / 4
    walk.offset = offset;
}

vec4 walk_gradient(HypercubeWalk walk, uint seed) {
    uvec4 index = uvec4(low_bits_of_sum(walk.corner.x), low_bits_of_sum(walk.corner.y),
                        low_bits_of_sum(walk.corner.z), low_bits_of_sum(walk.corner.w));
    return hypercube_gradient(lattice_bits(index, seed) >> 26);
}

float simplex_noise(uint seed, LatticeSite site, real cell_w, real place_w) {
    HypercubeWalk walk = hypercube_walk(site, cell_w, place_w);
    exact float sum = 0.0;
    for (int i = 0; i < 5; ++i) {
        sum += simplex_kernel(walk_gradient(walk, seed), walk.offset, 0.5);
        step_walk(walk, i);
    }
    return sum * 62.0;
}
