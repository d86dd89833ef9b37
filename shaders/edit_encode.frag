#version 330 core
// Linear light as drawn, rows top first, to sRGB codes for the screen; `side`^2 samples a pixel.
uniform sampler2D samples;
uniform int side;

out vec4 fragment;

vec3 encoded(vec3 linear) {
    vec3 c = clamp(linear, 0.0, 1.0);
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThan(c, vec3(0.0031308)));
}

void main() {
    ivec2 low = side * ivec2(gl_FragCoord.xy);
    vec3 sum = vec3(0.0);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) sum += texelFetch(samples, low + ivec2(x, y), 0).rgb;
    fragment = vec4(encoded(sum / float(side * side)), 1.0);
}
