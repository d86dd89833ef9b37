#version 330 core
// Dear ImGui's colours: the vertices' and the textures' are both sRGB codes, blended as such.
in vec2 texture_uv;
in vec4 vertex_color;

uniform sampler2D image;

out vec4 fragment;

void main() { fragment = vertex_color * texture(image, texture_uv); }
