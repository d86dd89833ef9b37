// Needs maps/footprint.glsl, maps/level_size.glsl and color/srgb_encode.glsl.
// Base colour in linear light, under a headlight: ambient + (1 - ambient) |n.v| as in
// app/scene/shading.h, with n bumped by a normal map as in procedural/fill/tangent_frame.h. The target is
// linear float; sRGB encoding happens after averaging, on the host, but where ENCODED says that a
// sample is a pixel of the screen.
in vec3 eye_position;
in vec3 eye_normal;
in vec3 local_normal;
in vec4 local_tangent;  // w: sign of the bitangent
in vec2 texture_uv;
in vec4 vertex_color;
flat in vec4 texture_block;  // low u, low v, high u, high v

// A software OpenGL takes every branch, whichever way a uniform decides; so these are macros:
// ENCODED: see above. LIT, BUMPED: by a normal map. LEVELS: lookups choose a level. IN_BLOCKS: they
// keep to the block. PLACES: instead of a colour where and how it is looked up: u, v, level, light.
uniform sampler2D base_color;
uniform sampler2D normal_map;
uniform float normal_scale;
uniform mat3 normal_from_local;
uniform vec4 base_color_factor;
uniform float ambient;

out vec4 fragment;

// Bilinear in one level, half of its texels off the block's border; of a block under one texel the
// middle.
vec4 block_level(sampler2D map, float level) {
    vec2 half_texel = 0.5 / vec2(level_size(map, int(level)));
    vec2 middle = 0.5 * (texture_block.xy + texture_block.zw);
    vec2 low = min(texture_block.xy + half_texel, middle);
    vec2 high = max(texture_block.zw - half_texel, middle);
    return textureLod(map, clamp(texture_uv, low, high), level);
}

// Trilinear, of a level that is not negative.
vec4 block_lookup(sampler2D map, float level) {
    vec2 size = vec2(textureSize(map, 0));
    float last = floor(log2(max(size.x, size.y)));
    level = min(level, last);
    return mix(block_level(map, floor(level)), block_level(map, min(floor(level) + 1.0, last)),
               fract(level));
}

// The level is chosen here, as the specification has it, and not by the sampler, which may be half
// a level off: which texels are read is known beforehand (app/gl/draw/view_texels.h).
float level_of(sampler2D map) {
    float footprint = footprint_squared(texture_uv, vec2(textureSize(map, 0)));
    return 0.5 * log2(max(footprint, 1.0));
}

vec4 lookup(sampler2D map) {
    if (!LEVELS) return texture(map, texture_uv);
    float level = level_of(map);
    return IN_BLOCKS ? block_lookup(map, level) : textureLod(map, texture_uv, level);
}

// In eye space, of any length.
vec3 shading_normal() {
    if (!BUMPED) return eye_normal;
    vec3 normal = normalize(local_normal), tangent = normalize(local_tangent.xyz);
    vec3 bitangent = cross(normal, tangent) * local_tangent.w;
    vec3 share = (2.0 * lookup(normal_map).xyz - 1.0) * vec3(normal_scale, normal_scale, 1.0);
    return normal_from_local * (share.x * tangent + share.y * bitangent + share.z * normal);
}

// Lit on the side that the surface itself shows.
float headlight() {
    vec3 normal = shading_normal();
    float lengths = length(normal) * length(eye_position);
    float towards = dot(eye_normal, eye_position) > 0.0 ? 1.0 : -1.0;
    float cosine = lengths > 0.0 ? towards * dot(normal, eye_position) / lengths : 1.0;
    return ambient + (1.0 - ambient) * clamp(cosine, 0.0, 1.0);
}

void main() {
    if (PLACES) {
        fragment = vec4(texture_uv, level_of(base_color), LIT ? headlight() : 1.0);
        return;
    }
    vec4 color = lookup(base_color) * base_color_factor * vertex_color;
    vec3 light = LIT ? color.rgb * headlight() : color.rgb;
    fragment = vec4(ENCODED ? srgb_encoded(light) : light, 1.0);
}
