#version 330 core
// The environment as the eye sees it, sharp, rows top first.
uniform sampler2D environment;  // equirectangular, as app/light/environment.h has it
uniform vec3 corner;            // scene space: direction of the target's corner
uniform vec3 across, down;      // what a sample to the right and one below add to it

out vec4 fragment;

const float pi = 3.14159265358979;

void main() {
    vec3 d = normalize(corner + gl_FragCoord.x * across + gl_FragCoord.y * down);
    vec2 uv = vec2(0.5 * atan(d.z, d.x) / pi + 0.5, acos(clamp(d.y, -1.0, 1.0)) / pi);
    fragment = vec4(textureLod(environment, uv, 0.0).rgb, 1.0);
}
