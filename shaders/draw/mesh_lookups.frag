// The lookup of a sample in a texture, for the host to mark texels by (app/gl/draw/view_texels.h):
// its place, its squared width and its triangle's number from 1 on; 0 where the sample does not
// show the texture. This part must follow maps/footprint.glsl.
in vec2 texture_uv;

uniform vec2 texture_size;
uniform int first_triangle;  // negative: the surface has another texture

out vec4 fragment;

void main() {
    float footprint = footprint_squared(texture_uv, texture_size);
    float number = first_triangle < 0 ? 0.0 : float(first_triangle + gl_PrimitiveID + 1);
    fragment = vec4(texture_uv, footprint, number);
}
