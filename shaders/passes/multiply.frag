// The product of two images: modulating one with the other.
out vec4 color;

void main() {
    color = stored(product(numbers(first), numbers(second)));
}
