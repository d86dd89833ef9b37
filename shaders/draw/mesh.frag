// Base colour in linear light, under a headlight: ambient + (1 - ambient) |n.v| as in
// app/scene/shading.h, with n bumped by a normal map as in procedural/fill/tangent_frame.h. The
// target is linear float, which the host encodes to sRGB after averaging, except with ENCODED,
// where a sample is a pixel of the screen. This part must follow maps/footprint.glsl,
// maps/level_size.glsl and color/srgb_encode.glsl.
in vec3 eye_position;
in vec3 eye_normal;
in vec3 local_normal;
in vec4 local_tangent;  // w: sign of the bitangent
in vec2 texture_uv;
in vec4 vertex_color;
flat in vec4 texture_block;  // low u, low v, high u, high v

// Macros, because software OpenGL executes every branch even of a uniform condition. ENCODED: the
// colour is encoded to sRGB. LIT: the headlight shades it. BUMPED: a normal map bumps the normal.
// LEVELS: lookups choose a MIP level. IN_BLOCKS: lookups stay in the block. PLACES: the fragment is
// u, v, level and light instead of a colour. MASKS: what has little alpha is not there. BLENDS: the
// colour is multiplied by alpha, and shown only between two depths.
uniform sampler2D base_color;
uniform sampler2D normal_map;
uniform float normal_scale;
uniform mat3 normal_from_local;
uniform vec4 base_color_factor;
uniform float ambient;
uniform float alpha_cutoff;
uniform sampler2D nearer;   // depth of the layer that was drawn before
uniform sampler2D farther;  // depth of what is opaque

out vec4 fragment;

// Bilinear lookup in one level, at least half a texel inside the block's border; in the middle of a
// block smaller than a texel.
vec4 block_level(sampler2D map, float level) {
    vec2 half_texel = 0.5 / vec2(level_size(map, int(level)));
    vec2 middle = 0.5 * (texture_block.xy + texture_block.zw);
    vec2 low = min(texture_block.xy + half_texel, middle);
    vec2 high = max(texture_block.zw - half_texel, middle);
    return textureLod(map, clamp(texture_uv, low, high), level);
}

// Trilinear lookup between two levels, for a level that is not negative.
vec4 block_lookup(sampler2D map, float level) {
    vec2 size = vec2(textureSize(map, 0));
    float last = floor(log2(max(size.x, size.y)));
    level = min(level, last);
    return mix(block_level(map, floor(level)), block_level(map, min(floor(level) + 1.0, last)),
               fract(level));
}

// The MIP level by the specification's formula and not by the sampler, which may be half a level
// off: the host must know the texels that are read (app/gl/draw/view_texels.h).
float level_of(sampler2D map) {
    float footprint = footprint_squared(texture_uv, vec2(textureSize(map, 0)));
    return 0.5 * log2(max(footprint, 1.0));
}

vec4 lookup(sampler2D map) {
    if (!LEVELS) return texture(map, texture_uv);
    float level = level_of(map);
    return IN_BLOCKS ? block_lookup(map, level) : textureLod(map, texture_uv, level);
}

// The shading normal in eye space, of any length.
vec3 shading_normal() {
    if (!BUMPED) return eye_normal;
    vec3 normal = normalize(local_normal), tangent = normalize(local_tangent.xyz);
    vec3 bitangent = cross(normal, tangent) * local_tangent.w;
    vec3 share = (2.0 * lookup(normal_map).xyz - 1.0) * vec3(normal_scale, normal_scale, 1.0);
    return normal_from_local * (share.x * tangent + share.y * bitangent + share.z * normal);
}

// The headlight's share of light, on the side that the surface itself shows.
float headlight() {
    vec3 normal = shading_normal();
    float lengths = length(normal) * length(eye_position);
    float towards = dot(eye_normal, eye_position) > 0.0 ? 1.0 : -1.0;
    float cosine = lengths > 0.0 ? towards * dot(normal, eye_position) / lengths : 1.0;
    return ambient + (1.0 - ambient) * clamp(cosine, 0.0, 1.0);
}

// Whether the fragment lies behind the layer that was drawn before, and before what is opaque.
bool is_in_layer() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    return gl_FragCoord.z > texelFetch(nearer, at, 0).r &&
           gl_FragCoord.z < texelFetch(farther, at, 0).r;
}

void main() {
    if (PLACES) {
        fragment = vec4(texture_uv, level_of(base_color), LIT ? headlight() : 1.0);
        return;
    }
    vec4 color = lookup(base_color) * base_color_factor * vertex_color;
    vec3 light = LIT ? color.rgb * headlight() : color.rgb;
    // Last, because lookups need the neighbours of fragments that are discarded.
    if (MASKS && color.a < alpha_cutoff) discard;
    if (BLENDS && (color.a <= 0.0 || !is_in_layer())) discard;
    float alpha = BLENDS ? min(color.a, 1.0) : 1.0;
    fragment = vec4(ENCODED ? srgb_encoded(light) : BLENDS ? alpha * light : light, alpha);
}
