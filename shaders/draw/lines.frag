#version 330 core
// A line in one colour, in linear light; alpha covers the pixels below.
uniform vec4 color;

out vec4 fragment;

void main() {
    fragment = color;
}
