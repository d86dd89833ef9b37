// An image added to another: blending with factors.
uniform float scale, bias;
out vec4 color;

void main() {
    color = stored(numbers(first) + (scale * numbers(second) + bias));
}
