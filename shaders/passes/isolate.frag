// The luminance image of one channel.
out vec4 color;

void main() {
    color = stored(vec4(numbers(first)[axis]));
}
