#version 330 core
// Base colour in linear light, under a headlight: ambient + (1 - ambient) |n.v| as in
// app/shading.h. The target is linear float; sRGB encoding happens after averaging, on the host.
in vec3 eye_position;
in vec3 eye_normal;
in vec2 texture_uv;
in vec4 vertex_color;
flat in vec4 texture_block;  // low u, low v, high u, high v

uniform sampler2D base_color;
uniform vec4 base_color_factor;
uniform bool in_blocks;  // lookups keep to the block
uniform bool lit;
uniform float ambient;

out vec4 fragment;

float headlight() {
    float lengths = length(eye_normal) * length(eye_position);
    float cosine = lengths > 0.0 ? abs(dot(eye_normal, eye_position)) / lengths : 1.0;
    return ambient + (1.0 - ambient) * min(cosine, 1.0);
}

// Bilinear in one level, half of its texels off the block's border; of a block under one texel the
// middle.
vec4 block_level(float level) {
    vec2 half_texel = 0.5 / vec2(textureSize(base_color, int(level)));
    vec2 middle = 0.5 * (texture_block.xy + texture_block.zw);
    vec2 low = min(texture_block.xy + half_texel, middle);
    vec2 high = max(texture_block.zw - half_texel, middle);
    return textureLod(base_color, clamp(texture_uv, low, high), level);
}

// Trilinear, the level chosen as OpenGL does (specification 8.14.1, the larger derivative).
vec4 block_lookup() {
    vec2 size = vec2(textureSize(base_color, 0));
    vec2 along_x = dFdx(texture_uv) * size, along_y = dFdy(texture_uv) * size;
    float footprint = max(max(dot(along_x, along_x), dot(along_y, along_y)), 1.0);
    float last = floor(log2(max(size.x, size.y)));
    float level = min(0.5 * log2(footprint), last);
    return mix(block_level(floor(level)), block_level(min(floor(level) + 1.0, last)),
               fract(level));
}

void main() {
    vec4 texel = in_blocks ? block_lookup() : texture(base_color, texture_uv);
    vec4 color = texel * base_color_factor * vertex_color;
    fragment = vec4(lit ? color.rgb * headlight() : color.rgb, 1.0);
}
