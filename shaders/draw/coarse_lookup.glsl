// Lookups of a surface's textures at the vertices of a coarse one. A vertex is one of the full
// surface's, so that its place at level 0 reads no foreign texel; between vertices places mean
// nothing.
layout(location = 2) in vec2 uv;

vec4 lookup(sampler2D map) {
    return textureLod(map, uv, 0.0);
}
