#version 330 core
// The ground as a square, four vertices without attributes.
uniform mat4 clip_from_ground;  // from the square's coordinates, 0 to 1, in x and z

out vec2 place;

void main() {
    place = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = clip_from_ground * vec4(place.x, 0.0, place.y, 1.0);
}
