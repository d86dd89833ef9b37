// A texel of a point map (procedural/batch/point_map.h). This part must follow maps/line.glsl.
layout(location = 0) out uvec4 map_xy;
layout(location = 1) out uvec4 map_z_owner;

void main() {
    dvec3 point = line_point();
    map_xy = uvec4(unpackDouble2x32(point.x), unpackDouble2x32(point.y));
    map_z_owner = uvec4(unpackDouble2x32(point.z), owner, 0u);
}
