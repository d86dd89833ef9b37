// A corner's random number: the host's lattice value in [-1, 1), or its upper eight bits with
// FIXED8. This part must follow passes/multipass.glsl and noise/lattice.glsl.
uniform uint seed;

vec4 hash_pass() {
    uint h = lattice_bits(lattice_cells(0u), seed);
#if FIXED8
    return vec4(float(h >> 24 ^ 128u));
#else
    return vec4(lattice_value(h));
#endif
}
