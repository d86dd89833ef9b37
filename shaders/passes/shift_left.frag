// A logical shift to the left: the highest bit is dropped, the others double.
out vec4 color;

void main() {
    vec4 x = numbers(first);
    color = stored(2.0 * (x - 128.0 * step(128.0, x)));
}
