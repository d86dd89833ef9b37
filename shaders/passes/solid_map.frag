// The papers' input: coordinates as colours of b_i.b_f bits.
out vec4 color;

void main() {
    uint fraction_bits = 8u - integer_bits;
    uvec3 coordinates = (cells() - base_cell) << fraction_bits | places() >> (32u - fraction_bits);
    color = stored(vec4(vec3(coordinates & 255u), 0.0));
}
