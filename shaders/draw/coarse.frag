#version 330 core
// A pixel of a coarse surface, whose vertices draw/coarse.vert shades.
in vec3 shade;

out vec4 fragment;

void main() {
    fragment = vec4(shade, 1.0);
}
