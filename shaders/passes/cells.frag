// The integers of the lattice coordinates: the cell's lowest corner, modulo 2^32.
out uvec4 integers;

void main() {
    integers = uvec4(cells(), 0u);
}
