// A coarse surface's vertex, shaded as draw/mesh.frag shades a fragment that faces the eye; pixels
// between vertices have the means of their codes. This part must follow color/srgb_encode.glsl,
// draw/tone.glsl, draw/coarse_lookup.glsl, draw/light.glsl and draw/material.glsl.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 3) in vec4 color;
layout(location = 5) in vec4 tangent;
layout(location = 6) in vec3 position_change;
layout(location = 7) in vec3 normal_change;
layout(location = 8) in vec3 tangent_change;

// Macros of draw/mesh.frag: ENCODED, LIT, BUMPED and AMBIENT.
uniform mat4 clip_from_local;
uniform mat4 eye_from_local;
uniform mat3 normal_from_local;
uniform mat3 scene_from_eye;
uniform float target_share;
uniform sampler2D base_color;
uniform sampler2D normal_map;
uniform float normal_scale;
uniform vec4 base_color_factor;
uniform float ambient;

out vec3 shade;

vec3 bumped_normal(vec3 local_normal) {
    if (!BUMPED) return normal_from_local * local_normal;
    vec3 n = normalize(local_normal), t = normalize(tangent.xyz + target_share * tangent_change);
    vec3 share = (2.0 * lookup(normal_map).xyz - 1.0) * vec3(normal_scale, normal_scale, 1.0);
    return normal_from_local * (share.x * t + share.y * cross(n, t) * tangent.w + share.z * n);
}

// The side of a surface's vertex that is seen, 1 or -1, by its normal alone: triangles of a coarse
// surface may be thin.
float side_seen(vec3 smooth_normal, vec3 eye) {
    return dot(smooth_normal, eye) > 0.0 ? -1.0 : 1.0;
}

vec3 light_of(vec3 base, vec3 bumped, vec3 smooth_normal, vec3 eye) {
    float side = side_seen(smooth_normal, eye);
    vec3 n = side * normalize(bumped);
    if (!AMBIENT)
        return base * (ambient + (1.0 - ambient) * clamp(-dot(n, normalize(eye)), 0.0, 1.0));
    return ambient_shading(point_of(clamp(base, 0.0, 1.0)), scene_from_eye * n,
                           side * normalize(scene_from_eye * smooth_normal),
                           -normalize(scene_from_eye * eye));
}

void main() {
    vec3 place = position + target_share * position_change;
    gl_Position = clip_from_local * vec4(place, 1.0);
    vec3 eye = (eye_from_local * vec4(place, 1.0)).xyz;
    vec3 local_normal = normal + target_share * normal_change;
    vec3 base = (lookup(base_color) * base_color_factor * color).rgb;
    vec3 light = LIT ? light_of(base, bumped_normal(local_normal),
                                normal_from_local * local_normal, eye)
                     : base;
    shade = ENCODED ? srgb_encoded(developed(light)) : light;
}
