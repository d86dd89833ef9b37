// The square of the longer side of a sample's footprint, in texels of level 0 of a texture of
// `size` texels (OpenGL 4.5 specification 8.14.1, the larger derivative).
float footprint_squared(vec2 uv, vec2 size) {
    vec2 along_x = dFdx(uv) * size, along_y = dFdy(uv) * size;
    return max(dot(along_x, along_x), dot(along_y, along_y));
}
