// Float64 numbers that textures hold as two words. This part must follow numbers/real.glsl.
#if REAL_IS_DOUBLE
real real_from_bits(uint low, uint high) {
    return packDouble2x32(uvec2(low, high));
}
#else
// The number rounded to 24 bits; what float does not hold becomes 0 or NaN.
real real_from_bits(uint low, uint high) {
    int exponent = int(high >> 20 & 0x7ffu) - 1023;
    uint sign = high & 0x80000000u;
    if (exponent < -126) return 0.0;
    if (exponent > 127) return uintBitsToFloat(0x7fc00000u);
    uint fraction = (high & 0xfffffu) << 3 | low >> 29;
    return uintBitsToFloat(sign | (uint(exponent + 127) << 23) + fraction + (low >> 28 & 1u));
}
#endif
