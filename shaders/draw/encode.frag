#version 330 core
// Linear light as drawn, rows top first, to sRGB codes for the screen, with `side`^2 samples a
// pixel. This part must follow color/srgb_encode.glsl.
uniform sampler2D samples;
uniform int side;

out vec4 fragment;

void main() {
    ivec2 low = side * ivec2(gl_FragCoord.xy);
    vec3 sum = vec3(0.0);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) sum += texelFetch(samples, low + ivec2(x, y), 0).rgb;
    fragment = vec4(srgb_encoded(sum / float(side * side)), 1.0);
}
