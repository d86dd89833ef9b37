// A corner's random number: the host's lattice value in [-1, 1), or its upper eight bits with
// FIXED8.
uniform uint seed;
out vec4 color;

void main() {
    uint h = lattice_bits(lattice_cells(0u), seed);
#if FIXED8
    color = stored(vec4(float(h >> 24 ^ 128u)));
#else
    color = stored(vec4(lattice_value(h)));
#endif
}
