#version 330 core
// Linear light as drawn, rows top first, to sRGB codes for the screen, with `side`^2 samples a
// pixel. Samples are multiplied by alpha, the share that they hide of the background, which is not
// developed. This part must follow color/srgb_encode.glsl and draw/tone.glsl.
uniform sampler2D samples;
uniform int side;
uniform vec3 background;  // linear

out vec4 fragment;

void main() {
    ivec2 low = side * ivec2(gl_FragCoord.xy);
    vec4 sum = vec4(0.0);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) sum += texelFetch(samples, low + ivec2(x, y), 0);
    vec4 mean = sum / float(side * side);
    vec3 light = mean.a * developed(mean.rgb / max(mean.a, 1e-6));
    fragment = vec4(srgb_encoded(light + (1.0 - mean.a) * background), 1.0);
}
