// Lookups of a surface's textures. This part must follow maps/footprint.glsl and
// maps/level_size.glsl.
in vec2 texture_uv;
flat in vec4 texture_block;  // low u, low v, high u, high v

uniform float most_probes;  // of a lookup, with ANISOTROPIC

// Macros. LEVELS: lookups choose a MIP level. IN_BLOCKS: lookups stay in the block. ANISOTROPIC:
// they are made of several along the longer side of the footprint.

// Bilinear lookup in one level, at least half a texel inside the block's border; in the middle of a
// block smaller than a texel.
vec4 block_level(sampler2D map, vec2 uv, float level) {
    vec2 half_texel = 0.5 / vec2(level_size(map, int(level)));
    vec2 middle = 0.5 * (texture_block.xy + texture_block.zw);
    vec2 low = min(texture_block.xy + half_texel, middle);
    vec2 high = max(texture_block.zw - half_texel, middle);
    return textureLod(map, clamp(uv, low, high), level);
}

// Trilinear lookup between two levels, for a level that is not negative.
vec4 block_lookup(sampler2D map, vec2 uv, float level) {
    vec2 size = vec2(textureSize(map, 0));
    float last = floor(log2(max(size.x, size.y)));
    level = min(level, last);
    return mix(block_level(map, uv, floor(level)),
               block_level(map, uv, min(floor(level) + 1.0, last)), fract(level));
}

// The MIP level by the specification's formula and not by the sampler, which may be half a level
// off: the host must know the texels that are read (app/gl/draw/view_texels.h).
float level_of(sampler2D map) {
    float footprint = footprint_squared(texture_uv, vec2(textureSize(map, 0)));
    return 0.5 * log2(max(footprint, 1.0));
}

vec4 lookup_at(sampler2D map, vec2 uv, float level) {
    return IN_BLOCKS ? block_lookup(map, uv, level) : textureLod(map, uv, level);
}

// The mean of as many lookups as the footprint is longer than wide, in the level of the part that
// each stands for: the example of GL_EXT_texture_filter_anisotropic.
vec4 anisotropic_lookup(sampler2D map) {
    vec2 size = vec2(textureSize(map, 0)), x = dFdx(texture_uv), y = dFdy(texture_uv);
    float xx = dot(x * size, x * size), yy = dot(y * size, y * size);
    float longer = sqrt(max(xx, yy)), shorter = sqrt(min(xx, yy));
    float probes = longer < most_probes * shorter ? ceil(longer / shorter - 1e-4) : most_probes;
    float level = log2(max(longer / probes, 1.0));
    vec4 sum = vec4(0.0);
    for (float i = 1.0; i <= probes; ++i)
        sum += lookup_at(map, texture_uv + (i / (probes + 1.0) - 0.5) * (xx > yy ? x : y), level);
    return sum / probes;
}

vec4 lookup(sampler2D map) {
    if (!LEVELS) return texture(map, texture_uv);
    if (ANISOTROPIC) return anisotropic_lookup(map);
    return lookup_at(map, texture_uv, level_of(map));
}
