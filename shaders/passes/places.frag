// The fractions of the lattice coordinates, in [0, 1].
out vec4 color;

void main() {
    color = stored(vec4(vec3(places()) * 2.3283064365386962890625e-10, 0.0));  // 2^-32
}
