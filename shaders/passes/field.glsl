// The field value that the index image stands for. This part must follow numbers/real.glsl and
// passes/multipass.glsl.
real field(ivec2 texel) {
    float t = numbers(first).x;
#if FIXED8 && COLOR_REPEATS
    return real(t + 0.5) / real(256.0);
#else
    return real(t) / real(one);
#endif
}
