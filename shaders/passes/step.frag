// The integers of the cell's opposite corner.
out uvec4 integers;

void main() {
    integers = texelFetch(first_integers, texel(), 0) + 1u;
}
