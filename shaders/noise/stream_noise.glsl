// The octaves that have a stream kernel on the host (procedural/kernels/stream_noise-inl.h,
// simplex_kernel.cpp), from the same fixed-point coordinates in the same sequence of operations:
// with IEEE arithmetic the same bits. Noise is divided by stream_unit(kind). This part must follow
// numbers/real.glsl and noise/lattice.glsl.

// A texel in the lattice of an octave: cells modulo 2^32, places in the cells in units of 2^-32.
struct StreamSite {
    uvec3 cell, place;
};

StreamSite doubled(StreamSite site, int doublings) {
    if (doublings == 0) return site;
    return StreamSite(site.cell << doublings | site.place >> (32 - doublings),
                      site.place << doublings);
}

// 2^32 times the offset from the cell's middle, rounded to float.
vec3 centred_places(uvec3 place) {
    return vec3(ivec3(place ^ 0x80000000u));
}

// Twice the place about the cell's middle, t in [-1, 1].
vec3 twice_places(vec3 s) {
    return s * 4.656612873077392578125e-10;  // 2^-31
}

// The fades v = 2 w - 1 from centred_places.
vec3 stream_fade_linear(vec3 s) {
    return twice_places(s);
}
vec3 stream_fade_smooth(vec3 s) {  // t (3/2 - t^2 / 2), t = 2^-31 s: 3 2^-32 and 2^-94
    exact vec3 v = s * (6.984919309616088867e-10 - 5.048709793414475549e-29 * (s * s));
    return v;
}
vec3 stream_fade_quintic(vec3 s) {  // t (15/8 - t^2 (5/4 - 3/8 t^2))
    vec3 t = twice_places(s), square = t * t;
    exact vec3 v = t * (1.875 - square * (1.25 - 0.375 * square));
    return v;
}

// ---- Value noise ----

// The hash of the cell's lowest corner before mixing; the other corners' hashes are sums of primes
// higher.
uint cell_hash(uvec3 cell, uint seed) {
    return cell.x * prime_x + seed + cell.y * prime_y + cell.z * prime_z;
}

uvec4 plane_hashes(uint h) {
    uint above = h + prime_y;
    return uvec4(mix_bits(h), mix_bits(h + prime_x), mix_bits(above), mix_bits(above + prime_x));
}

// Four times the interpolation of a plane's lattice values, times 2^31.
float value_plane(uint h, vec3 fade) {
    vec4 n = vec4(ivec4(plane_hashes(h) & 0xffffff00u));
    float low = n.x + n.y, high = n.z + n.w, low_x = n.y - n.x, high_x = n.w - n.z;
    exact float plane = (low + high + fade.x * (low_x + high_x)) +
                        fade.y * ((high - low) + fade.x * (high_x - low_x));
    return plane;
}

// Value noise; `seed` is the octave's seed times prime_seed.
float stream_value(StreamSite site, uint seed, vec3 fade) {
    uint h = cell_hash(site.cell, seed);
    return twice_lerp(fade.z, value_plane(h, fade), value_plane(h + prime_z, fade));
}
float stream_value_linear(StreamSite site, uint seed) {
    return stream_value(site, seed, stream_fade_linear(centred_places(site.place)));
}
float stream_value_smooth(StreamSite site, uint seed) {
    return stream_value(site, seed, stream_fade_smooth(centred_places(site.place)));
}
float stream_value_quintic(StreamSite site, uint seed) {
    return stream_value(site, seed, stream_fade_quintic(centred_places(site.place)));
}

// ---- Perlin noise ----

float with_sign(float x, uint bits) {
    return uintBitsToFloat(floatBitsToUint(x) ^ (bits & 0x80000000u));
}

// The slope through a corner at offset (x, y, z); the gradient's number is in the upper four bits
// of h.
float perlin_corner(uint h, float x, float y, float z) {
    uint number = h >> 28;
    float a = number < 8u ? x : y;
    float b = number < 4u ? y : (number == 12u || number == 14u ? x : z);
    return with_sign(a, h << 3) + with_sign(b, h << 2);
}

float perlin_plane(uint h, vec3 t, float z, vec3 fade) {
    uvec4 hash = plane_hashes(h);
    float x0 = t.x + 1.0, x1 = t.x - 1.0, y0 = t.y + 1.0, y1 = t.y - 1.0;
    float low = twice_lerp(fade.x, perlin_corner(hash.x, x0, y0, z), perlin_corner(hash.y, x1, y0, z));
    float high = twice_lerp(fade.x, perlin_corner(hash.z, x0, y1, z), perlin_corner(hash.w, x1, y1, z));
    return twice_lerp(fade.y, low, high);
}

// Perlin noise; `seed` is the octave's seed times prime_seed.
float stream_perlin(StreamSite site, uint seed) {
    vec3 s = centred_places(site.place), fade = stream_fade_quintic(s), t = twice_places(s);
    uint h = cell_hash(site.cell, seed);
    return twice_lerp(fade.z, perlin_plane(h, t, t.z + 1.0, fade),
                      perlin_plane(h + prime_z, t, t.z - 1.0, fade));
}

// ---- Simplex noise ----

// The quotient and rest of n / 3 modulo 2^32, for -2^31 < n < 2^31 - 2: products with the inverse
// of 3 lie far apart for the three rests.
uint third(uint n, out uint rest) {
    uint product = n * 0xaaaaaaabu;
    int place = int(product);
    rest = place > 0x2aaaaaaa ? 2u : place < -0x2aaaaaaa ? 1u : 0u;
    return product - rest * 0xaaaaaaabu;
}

// The appendix's pattern by one bit of each coordinate.
uint bit_pattern(uint number) {
    return ((number & 4u) == 0u ? 0x2c323815u : 0x2a07130du) >> 8u * (number & 3u) & 63u;
}

// The sum of the patterns of a corner's lower eight bits; its lower six bits name a gradient.
uint pattern_hash(uvec3 i) {
    // From bit to bit another coordinate is the highest in a pattern's number; x, y and z here are
    // the highest, the middle and the lowest ones.
    uvec3 turned = uvec3(i.x & 0x49u | i.y & 0x92u | i.z & 0x24u, i.y & 0x49u | i.z & 0x92u | i.x & 0x24u,
                         i.z & 0x49u | i.x & 0x92u | i.y & 0x24u);
    uint sum = 0u;
    for (int bit = 0; bit < 8; ++bit) {
        uvec3 b = turned >> bit & 1u;
        sum += bit_pattern(b.x << 2 | b.y << 1 | b.z);
    }
    return sum;
}

// Twice the gradient: components 2, 0 and -2.
vec3 simplex_gradient(uint hash) {
    uint turn = hash & 3u, b3 = hash >> 3 & 1u, b4 = hash >> 4 & 1u, b5 = hash >> 5 & 1u;
    bool corner = turn == 0u, b2 = (hash & 4u) != 0u;
    float p = b5 == b3 ? -2.0 : 2.0;
    float q = corner || !b2 ? (b5 == b4 ? -2.0 : 2.0) : 0.0;
    float r = corner || b2 ? (b5 != (b4 ^ b3) ? -2.0 : 2.0) : 0.0;
    return turn == 1u ? vec3(p, q, r) : turn == 2u ? vec3(r, p, q) : vec3(q, r, p);
}

// The number t = radius2 - d . d, or 0 where that is negative, of a corner's kernel t^4 (g . d).
float simplex_height(vec3 offset, float radius2) {
    exact float square = offset.x * offset.x + offset.y * offset.y + offset.z * offset.z;
    return max(radius2 - square, 0.0);
}

float simplex_kernel(uvec3 corner, vec3 offset, float radius2) {
    vec3 g = simplex_gradient(pattern_hash(corner));
    float t = simplex_height(offset, radius2);
    exact float t4 = (t * t) * (t * t);
    return t4 * exact_dot(g, offset);
}

// The corners of the simplex from the lowest to the highest, and the texel's offsets from them.
struct SimplexCorners {
    uvec3 corner[4];
    vec3 offset[4];
};

// The corners of a site; `shift` is what the octave's seed adds to corners (lattice_shift).
SimplexCorners simplex_corners(StreamSite site, uvec3 shift) {
    const uint one = 1u << 29;
    uvec3 p = site.place >> 3;
    // The skew is a third of the coordinates' sum; it is 1 too small, so that small sums are
    // negative numbers.
    uint rest, unused;
    uint cells = third(site.cell.x + site.cell.y + site.cell.z, rest);
    uint skew = third(p.x + p.y + p.z - 3u * one + rest * one, unused);
    uvec3 skewed = p + skew;
    uvec3 corner = site.cell + cells + uvec3(ivec3(skewed) >> 29) + 1u + shift;
    ivec3 way = ivec3(skewed << 3 ^ 0x80000000u);
    // The place in the skewed cube, from its middle; unskewing subtracts a sixth of the sum.
    vec3 y = vec3(way) * 2.3283064365386962890625e-10;  // 2^-32
    exact float back = 0.25 - (y.x + y.y + y.z) * 0.16666667163372039794921875;
    exact vec3 offset = y + back;

    // The largest offset goes first; of equal ones that along the lower axis.
    bool xy = way.x < way.y, xz = way.x < way.z, yz = way.y < way.z;
    uvec3 first = uvec3(bvec3(!(xy || xz), xy && !yz, xz && yz));
    uvec3 last = uvec3(bvec3(xy && xz, !xy && yz, !(xz || yz)));
    exact vec3 second = (offset + 0.16666667163372039794921875) - vec3(first);
    exact vec3 third_offset = (offset - 0.666666686534881591796875) + vec3(last);
    exact vec3 highest = offset - 0.5;
    return SimplexCorners(uvec3[4](corner, corner + first, corner + 1u - last, corner + 1u),
                          vec3[4](offset, second, third_offset, highest));
}

float stream_simplex(StreamSite site, uvec3 shift, float radius2) {
    SimplexCorners at = simplex_corners(site, shift);
    exact float noise = simplex_kernel(at.corner[0], at.offset[0], radius2) +
                        simplex_kernel(at.corner[1], at.offset[1], radius2) +
                        simplex_kernel(at.corner[2], at.offset[2], radius2) +
                        simplex_kernel(at.corner[3], at.offset[3], radius2);
    return noise;
}
