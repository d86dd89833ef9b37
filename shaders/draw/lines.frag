#version 330 core
// One colour, in linear light; alpha covers what lies below.
uniform vec4 color;

out vec4 fragment;

void main() {
    fragment = color;
}
