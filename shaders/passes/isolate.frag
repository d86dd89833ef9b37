// The luminance image of one channel of another image.
out vec4 color;

void main() {
    color = stored(vec4(numbers(first)[axis]));
}
