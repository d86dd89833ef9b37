#version 330 core
// A scene's surface: positions to clip space, the rest to the fragment shader in eye space; the
// frame of normal maps stays in the surface's own space. A share of the way to the morph target is
// added first; surfaces without a target have changes of 0.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 color;
layout(location = 4) in vec4 block;
layout(location = 5) in vec4 tangent;
layout(location = 6) in vec3 position_change;
layout(location = 7) in vec3 normal_change;
layout(location = 8) in vec3 tangent_change;

uniform mat4 clip_from_local;
uniform mat4 eye_from_local;
uniform mat3 normal_from_local;
uniform float target_share;

out vec3 eye_position;
out vec3 eye_normal;
out vec3 local_normal;
out vec4 local_tangent;
out vec2 texture_uv;
out vec4 vertex_color;
flat out vec4 texture_block;

void main() {
    vec3 place = position + target_share * position_change;
    gl_Position = clip_from_local * vec4(place, 1.0);
    eye_position = (eye_from_local * vec4(place, 1.0)).xyz;
    local_normal = normal + target_share * normal_change;
    eye_normal = normal_from_local * local_normal;
    local_tangent = vec4(tangent.xyz + target_share * tangent_change, tangent.w);
    texture_uv = uv;
    vertex_color = color;
    texture_block = block;
}
