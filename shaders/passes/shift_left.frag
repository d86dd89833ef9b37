// The highest bit falls off, then the others double: a logical shift.
out vec4 color;

void main() {
    vec4 x = numbers(first);
    color = stored(2.0 * (x - 128.0 * step(128.0, x)));
}
