// Stratified sample points in a texel and their weights, those of procedural/batch/sample_pattern.h
// to the bit. This part must follow noise/lattice.glsl.
uniform int sample_count;
uniform ivec2 sample_cells;  // columns and rows that the texel is cut into

// The offset of sample i of a texel of the atlas from its centre, along u and v, in texels, in
// [-1/2, 1/2].
real2 sample_offset(int i, ivec2 texel) {
    uint bits = lattice_bits(uvec3(uint(texel.x), uint(texel.y), uint(i)), 0x5eedu);
    exact real2 jitter = real2(real(bits >> 16), real(bits & 0xffffu)) * real(1.52587890625e-05) +
                         real(7.62939453125e-06);  // 2^-16 and 2^-17
    exact real2 offset =
        (real2(real(i % sample_cells.x), real(i / sample_cells.x)) + jitter) / real2(sample_cells) - real(0.5);
    return real2(vec2(offset));
}

real gaussian_weight(real2 at) {
    exact real x = real(0.5) - real(2.0) * (at.x * at.x + at.y * at.y);
    exact real sum = real(1.0) / real(6227020800.0);
    sum = real(1.0) / real(479001600.0) + x * sum;
    sum = real(1.0) / real(39916800.0) + x * sum;
    sum = real(1.0) / real(3628800.0) + x * sum;
    sum = real(1.0) / real(362880.0) + x * sum;
    sum = real(1.0) / real(40320.0) + x * sum;
    sum = real(1.0) / real(5040.0) + x * sum;
    sum = real(1.0) / real(720.0) + x * sum;
    sum = real(1.0) / real(120.0) + x * sum;
    sum = real(1.0) / real(24.0) + x * sum;
    sum = real(1.0) / real(6.0) + x * sum;
    sum = real(0.5) + x * sum;
    sum = real(1.0) + x * sum;
    sum = real(1.0) + x * sum;
    return sum;
}
