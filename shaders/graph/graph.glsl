// The operations of texture graphs that GLSL has no operator for, as in
// procedural/graph/value_kernels.cpp, value_program.cpp and mip_image.cpp. This part must follow
// noise/lattice.glsl and maps/level_size.glsl.

real odd_cell(real x) {
    exact real pairs = floor(x) * real(0.5);
    return pairs == floor(pairs) ? real(0.0) : real(1.0);
}

real fraction_of(real x) {
    exact real fraction = x - floor(x);
    return fraction;
}

// x with +0 for -0, as sums have it; compilers that leave out "+ 0.0" would keep -0.
real unsigned_zero(real x) {
    return x == real(0.0) ? abs(x) : x;
}

real ratio(real a, real b) {
    return b > real(0.0) ? a / b : real(0.0);
}

real length_of(real x, real y) {
    exact real squares = x * x + y * y;
    return nearest_root(squares);
}

real blend(real weight, real a, real b) {
    exact real sum = (real(1.0) - weight) * a + weight * b;
    return sum;
}

// The smooth step: 0 up to low, 1 from high on, 3u^2 - 2u^3 between; a step at `high` where high <=
// low.
real smooth_step(real low, real high, real x) {
    if (!(high > low)) return x >= high ? real(1.0) : real(0.0);
    exact real u = (x - low) / (high - low);
    exact real curve = (u * u) * (real(3.0) - (u + u));
    return x >= high ? real(1.0) : x <= low ? real(0.0) : curve;
}

// x, or 0 where x is not finite.
real finite_or_zero(real x) {
    exact real zero = x - x;
    return zero == real(0.0) ? x : real(0.0);
}

// A colour map's argument clamped to [0, 1].
real clamped_index(real x) {
    return min(max(finite_or_zero(x), real(0.0)), real(1.0));
}
// A colour map's argument modulo 1.
real repeated_index(real x) {
    real part = fraction_of(finite_or_zero(x));
    // Just below a whole number the fraction rounds to 1, which is the next period's 0.
    return part < real(1.0) ? part : real(0.0);
}

// The disk of the unit square around (x, y), if it has one: (dx, dy) is the point from its middle.
struct DotDisk {
    bool there;
    real dx, dy;
};

// The random number in [-1, 1) of the square that lies `across` and `down` squares from this one.
real dot_number(uvec2 square, int across, int down, uint seed, uvec2 period) {
    uint i = lattice_index(square.x, across, period.x), j = lattice_index(square.y, down, period.y);
    return real(lattice_value(lattice_bits(uvec3(i, j, 0u), seed)));
}

// The disk of the square around (x, y): half of the squares have one, and square (i, j) draws three
// random numbers. `period` is in squares, 0 for none.
DotDisk dot_disk(real x, real y, uint seed, uvec2 period, real radius) {
    exact real shift = real(0.5) - radius;
    exact real3 corner = real3(x + real(0.5), y + real(0.5), real(0.0));
    uvec2 square = cell_bits(lattice_site(corner, uvec3(period, 0u))).xy;
    exact real chance = shift * dot_number(square, 0, 0, seed, period);
    exact real dx = x - (floor(corner.x) + shift * dot_number(square, 1, 2, seed, period));
    exact real dy = y - (floor(corner.y) + shift * dot_number(square, 4, 9, seed, period));
    return DotDisk(chance >= real(0.0), dx, dy);
}

// The weight of `inside` in the node `dots`: 1 in a disk, else 0.
real dot_weight(real x, real y, uint seed, uvec2 period, real radius) {
    DotDisk disk = dot_disk(x, y, seed, period, radius);
    exact real squares = disk.dx * disk.dx + disk.dy * disk.dy;
    exact real inside = radius - nearest_root(squares);
    return disk.there && inside >= real(0.0) ? real(1.0) : real(0.0);
}

// The index of texel x of `size`; beyond an image lies the image again (wrap 0), black (1, index
// -1) or its border (2).
int image_index(real x, int size, int wrap) {
    real n = real(size);
    if (wrap == 2) return int(min(max(x, real(0.0)), n - real(1.0)));
    if (wrap == 1) return x >= real(0.0) && x < n ? int(x) : -1;
    exact real inside = x - n * floor(x / n);
    return int(inside);
}

// The size from which a coordinate has no useful fraction of a texel.
const real farthest_image = real(1099511627776.0);  // 2^40

real3 image_texel(sampler2D image, int level, real x, real y, int wrap) {
    ivec2 size = level_size(image, level);
    ivec2 texel = ivec2(image_index(x, size.x, wrap), image_index(y, size.y, wrap));
    if (texel.x < 0 || texel.y < 0) return real3(0.0);
    return real3(texelFetch(image, texel, level).rgb);
}

// Bilinear lookup in linear light; texel (0, 0) where a coordinate is farthest_image or more.
real3 image_color(sampler2D image, real s, real t, int wrap) {
    if (!(abs(s) < farthest_image && abs(t) < farthest_image))
        return image_texel(image, 0, real(0.0), real(0.0), wrap);
    ivec2 size = textureSize(image, 0);
    exact real x = s * real(size.x) - real(0.5), y = t * real(size.y) - real(0.5);
    real i = floor(x), j = floor(y);
    exact real u = x - i, v = y - j;
    real3 a = image_texel(image, 0, i, j, wrap), b = image_texel(image, 0, i + real(1.0), j, wrap),
          c = image_texel(image, 0, i, j + real(1.0), wrap),
          d = image_texel(image, 0, i + real(1.0), j + real(1.0), wrap);
    exact real3 low = (real(1.0) - u) * a + u * b;
    exact real3 high = (real(1.0) - u) * c + u * d;
    exact real3 color = (real(1.0) - v) * low + v * high;
    return color;
}
