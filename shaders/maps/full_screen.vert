#version 330 core
// One triangle over the whole target, from the vertex's number alone: (-1,-1), (3,-1), (-1,3).
void main() {
    gl_Position = vec4(float(gl_VertexID & 1) * 4.0 - 1.0, float(gl_VertexID & 2) * 2.0 - 1.0, 0.0, 1.0);
}
