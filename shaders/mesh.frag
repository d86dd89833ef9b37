#version 330 core
// Base colour in linear light, under a headlight: ambient + (1 - ambient) |n.v| as in
// app/shading.h. The target is linear float; sRGB encoding happens after averaging, on the host.
in vec3 eye_position;
in vec3 eye_normal;
in vec2 texture_uv;
in vec4 vertex_color;

uniform sampler2D base_color;
uniform vec4 base_color_factor;
uniform bool lit;
uniform float ambient;

out vec4 fragment;

float headlight() {
    float lengths = length(eye_normal) * length(eye_position);
    float cosine = lengths > 0.0 ? abs(dot(eye_normal, eye_position)) / lengths : 1.0;
    return ambient + (1.0 - ambient) * min(cosine, 1.0);
}

void main() {
    vec4 color = texture(base_color, texture_uv) * base_color_factor * vertex_color;
    fragment = vec4(lit ? color.rgb * headlight() : color.rgb, 1.0);
}
