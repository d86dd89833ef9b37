#version 330 core
// Draws a scene's surface: positions to clip space, the rest to the fragment shader in eye space;
// the frame of normal maps stays in the surface's own.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 color;
layout(location = 4) in vec4 block;
layout(location = 5) in vec4 tangent;

uniform mat4 clip_from_local;
uniform mat4 eye_from_local;
uniform mat3 normal_from_local;

out vec3 eye_position;
out vec3 eye_normal;
out vec3 local_normal;
out vec4 local_tangent;
out vec2 texture_uv;
out vec4 vertex_color;
flat out vec4 texture_block;

void main() {
    gl_Position = clip_from_local * vec4(position, 1.0);
    eye_position = (eye_from_local * vec4(position, 1.0)).xyz;
    eye_normal = normal_from_local * normal;
    local_normal = normal;
    local_tangent = tangent;
    texture_uv = uv;
    vertex_color = color;
    texture_block = block;
}
