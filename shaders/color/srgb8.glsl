// 8-bit sRGB codes of linear light, those of SrgbStreamEncoder in procedural/color/srgb.h.
// This part must follow numbers/real_bits.glsl. SRGB8_BUCKETS is the number of buckets as a float.
uniform usamplerBuffer srgb8_buckets;  // halves of the threshold in a bucket, and the code below it

uint srgb8(real linear) {
    real x = linear > real(0.0) ? min(linear, real(1.0)) : real(0.0);
    uvec4 bucket = texelFetch(srgb8_buckets, int(sqrt(float(x)) * SRGB8_BUCKETS));
    return x >= real_from_bits(bucket.x, bucket.y) ? bucket.z + 1u : bucket.z;
}
