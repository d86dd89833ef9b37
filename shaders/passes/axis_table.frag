// A random number by one coordinate of a corner: the papers' PixelMap.
uniform sampler2D tables;
out vec4 color;

void main() {
    uint cell = lattice_cells(upper ? 1u : 0u)[axis];
    color = stored(vec4(texelFetch(tables, ivec2(cell & 255u, 0), 0)[axis]));
}
