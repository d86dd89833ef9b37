#version 330 core
// A line as a rectangle of constant width on the screen, a little nearer than the surface it lies
// on.
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec3 from_change;  // change of `from` on the way to a morph target
layout(location = 3) in vec3 to_change;

uniform mat4 clip_from_unit;
uniform vec2 size;    // size of the target in samples
uniform float width;  // width of the line in samples
uniform float share;  // share of the way to the morph target

// The end itself or, where it lies before the near plane, the line's intersection with that plane.
vec4 before_the_eye(vec4 end, vec4 other) {
    float here = end.z + end.w, there = other.z + other.w;
    return here < 0.0 && there > 0.0 ? mix(end, other, here / (here - there)) : end;
}

void main() {
    vec4 a = clip_from_unit * vec4(from + share * from_change, 1.0);
    vec4 b = clip_from_unit * vec4(to + share * to_change, 1.0);
    vec4 low = before_the_eye(a, b), high = before_the_eye(b, a);
    vec2 along = (high.xy / high.w - low.xy / low.w) * size;
    float far = length(along);
    vec2 across = far > 0.0 ? vec2(-along.y, along.x) / far : vec2(1.0, 0.0);
    float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
    vec4 end = (gl_VertexID & 2) == 0 ? low : high;
    gl_Position = end + vec4(side * width * across / size * end.w, 0.0, 0.0);
}
