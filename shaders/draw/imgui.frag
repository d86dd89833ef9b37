#version 330 core
// Colours as they are: both the vertices' and the textures' are sRGB codes, blended as such.
in vec2 texture_uv;
in vec4 vertex_color;

uniform sampler2D image;

out vec4 fragment;

void main() { fragment = vertex_color * texture(image, texture_uv); }
