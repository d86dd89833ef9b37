// A texel of a solid map (procedural/batch/point_map.h). This part must follow maps/line.glsl.
uniform dvec3 base;

layout(location = 0) out vec4 map_local;
layout(location = 1) out uint map_owner;

void main() {
    precise dvec3 local = line_point() - base;
    map_local = vec4(vec3(local), 1.0);
    map_owner = owner;
}
