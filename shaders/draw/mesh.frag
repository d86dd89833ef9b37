// Linear light of a surface, with n bumped by a normal map as in procedural/fill/tangent_frame.h:
// under a headlight, the base colour times ambient + (1 - ambient) |n.v| as in
// app/scene/shading.h, or in an environment. The target is linear float, which the host develops
// and encodes after averaging, except with ENCODED, where a sample is a pixel of the screen. This
// part must follow color/srgb_encode.glsl, draw/tone.glsl, draw/lookup.glsl, draw/light.glsl and
// draw/material.glsl.
in vec3 eye_position;
in vec3 eye_normal;
in vec3 local_normal;
in vec4 local_tangent;  // w: sign of the bitangent
in vec4 vertex_color;

// Macros, because software OpenGL executes every branch even of a uniform condition. ENCODED: the
// colour is developed and encoded to sRGB. LIT: light shades it, an environment's with AMBIENT,
// else the headlight. BUMPED: a normal map bumps the normal. PLACES: the fragment is u, v, level
// and light instead of a colour. MASKS: what has little alpha is not there. BLENDS: the colour is
// multiplied by alpha. LAYERED: it is shown only between two depths.
uniform sampler2D base_color;
uniform sampler2D normal_map;
uniform float normal_scale;
uniform mat3 normal_from_local;
uniform mat3 scene_from_eye;
uniform vec4 base_color_factor;
uniform float ambient;
uniform float alpha_cutoff;
uniform sampler2D nearer;   // depth of the layer that was drawn before
uniform sampler2D farther;  // depth of what is opaque

layout(location = 0) out vec4 fragment;
// With PLACES and AMBIENT, the light that is sent to the eye is `dark` and, times the base colour,
// `bright`.
layout(location = 1) out vec4 dark;
layout(location = 2) out vec4 bright;

// The shading normal in eye space, of any length.
vec3 shading_normal() {
    if (!BUMPED) return eye_normal;
    vec3 normal = normalize(local_normal), tangent = normalize(local_tangent.xyz);
    vec3 bitangent = cross(normal, tangent) * local_tangent.w;
    vec3 share = (2.0 * lookup(normal_map).xyz - 1.0) * vec3(normal_scale, normal_scale, 1.0);
    return normal_from_local * (share.x * tangent + share.y * bitangent + share.z * normal);
}

// The headlight's share of light, on the side that the surface itself shows.
float headlight() {
    vec3 normal = shading_normal();
    float lengths = length(normal) * length(eye_position);
    float towards = dot(eye_normal, eye_position) > 0.0 ? 1.0 : -1.0;
    float cosine = lengths > 0.0 ? towards * dot(normal, eye_position) / lengths : 1.0;
    return ambient + (1.0 - ambient) * clamp(cosine, 0.0, 1.0);
}

// 1 where the side is seen that the surface's normals are on, -1 where the other one is: by the
// triangle itself, since interpolated normals turn away before it does.
float side_seen() {
    vec3 across = cross(dFdx(eye_position), dFdy(eye_position));
    float side = dot(across, eye_normal) * dot(across, eye_position);
    return side > 0.0 ? -1.0 : 1.0;
}

// Light of the environment that a surface of this base colour sends to the eye.
vec3 environment_light(vec3 base) {
    float side = side_seen();
    vec3 normal = side * normalize(scene_from_eye * shading_normal());
    vec3 coat_normal = side * normalize(scene_from_eye * eye_normal);
    return ambient_shading(point_of(clamp(base, 0.0, 1.0)), normal, coat_normal,
                           -normalize(scene_from_eye * eye_position));
}

// Whether the fragment lies behind the layer that was drawn before, and before what is opaque.
bool is_in_layer() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    return gl_FragCoord.z > texelFetch(nearer, at, 0).r &&
           gl_FragCoord.z < texelFetch(farther, at, 0).r;
}

void main() {
    if (PLACES) {
        fragment = vec4(texture_uv, level_of(base_color), LIT && !AMBIENT ? headlight() : 1.0);
        if (AMBIENT) {
            dark = vec4(environment_light(vec3(0.0)), 1.0);
            bright = vec4(environment_light(vec3(1.0)), 1.0) - dark;
        }
        return;
    }
    vec4 color = lookup(base_color) * base_color_factor * vertex_color;
    vec3 light = !LIT ? color.rgb : AMBIENT ? environment_light(color.rgb) : color.rgb * headlight();
    // Last, because lookups need the neighbours of fragments that are discarded.
    if (MASKS && color.a < alpha_cutoff) discard;
    if (BLENDS && (color.a <= 0.0 || (LAYERED && !is_in_layer()))) discard;
    float alpha = BLENDS ? min(color.a, 1.0) : 1.0;
    fragment = vec4(ENCODED ? srgb_encoded(developed(light)) : BLENDS ? alpha * light : light, alpha);
}
