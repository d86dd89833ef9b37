#version 330 core
// The shadow on the ground: black, as far as it hides what lies behind.
uniform sampler2D shadow;

in vec2 place;

out vec4 fragment;

void main() {
    fragment = vec4(0.0, 0.0, 0.0, texture(shadow, place).r);
}
