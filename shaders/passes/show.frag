// The image of a pass as colours: numbers times `scale` plus `bias`; whole numbers by their lower 8
// bits.
#if INTEGERS
uniform usampler2D first;
#else
uniform sampler2D first;
#endif
uniform float scale, bias;
layout(location = 0) out vec4 color;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
#if INTEGERS
    vec3 value = vec3(texelFetch(first, texel, 0).rgb & 255u) / 255.0;
#else
    vec3 value = texelFetch(first, texel, 0).rgb;
#endif
    color = vec4(clamp(value * scale + bias, 0.0, 1.0), 1.0);
}
