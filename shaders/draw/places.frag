#version 330 core
// Needs color/srgb_encode.glsl.
// The object's pixels from the places that they look their texture up at (draw/mesh.frag, PLACES), as
// draw/mesh.frag itself draws them.
uniform sampler2D places;
uniform sampler2D base_color;

out vec4 fragment;

void main() {
    vec4 place = texelFetch(places, ivec2(gl_FragCoord.xy), 0);
    vec3 color = textureLod(base_color, place.xy, place.z).rgb;
    fragment = vec4(srgb_encoded(color * place.w), 1.0);
}
