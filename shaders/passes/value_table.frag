// A random number by a sum of random numbers (the papers' PixelMap), or a histogram equalised.
uniform sampler2D tables;
out vec4 color;

void main() {
    float x = numbers(first).x;
    int number = int(floor(x * (255.0 / one) + 0.5));
    color = stored(vec4(texelFetch(tables, ivec2(number, 0), 0).w));
}
