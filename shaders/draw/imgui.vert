#version 330 core
// Dear ImGui's triangles: screen coordinates to clip space, y down.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 color;

uniform vec2 display_low;
uniform vec2 display_size;

out vec2 texture_uv;
out vec4 vertex_color;

void main() {
    vec2 share = (position - display_low) / display_size;
    gl_Position = vec4(2.0 * share.x - 1.0, 1.0 - 2.0 * share.y, 0.0, 1.0);
    texture_uv = uv;
    vertex_color = color;
}
