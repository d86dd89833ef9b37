// One of two luminances, chosen by an image's highest bit, blended over another image with alpha
// 1/8.
uniform vec2 colors;
out vec4 color;

void main() {
    vec4 over = mix(vec4(colors.x), vec4(colors.y), greaterThanEqual(numbers(first), vec4(128.0)));
    color = stored(floor((7.0 * numbers(second) + over + 4.0) * 0.125));
}
