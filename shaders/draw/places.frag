#version 330 core
// The object's pixels from the lookups that draw/mesh.frag stores with PLACES, equal to those that
// draw/mesh.frag itself draws. This part must follow color/srgb_encode.glsl.
uniform sampler2D places;
uniform sampler2D base_color;

out vec4 fragment;

void main() {
    vec4 place = texelFetch(places, ivec2(gl_FragCoord.xy), 0);
    vec3 color = textureLod(base_color, place.xy, place.z).rgb;
    fragment = vec4(srgb_encoded(color * place.w), 1.0);
}
