// One more randomisation, of the sum of random numbers: PixelMap. Or a histogram made equal.
uniform sampler2D tables;
out vec4 color;

void main() {
    float x = numbers(first).x;
    int number = int(floor(x * (255.0 / one) + 0.5));
    color = stored(vec4(texelFetch(tables, ivec2(number, 0), 0).w));
}
