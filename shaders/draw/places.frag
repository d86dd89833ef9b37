// The object's pixels from the lookups and the light that draw/mesh.frag stores with PLACES: those
// that draw/mesh.frag itself draws. This part must follow color/srgb_encode.glsl and draw/tone.glsl.
uniform sampler2D places;
uniform sampler2D dark, bright;  // light, and light times the base colour, with AMBIENT
uniform sampler2D base_color;

out vec4 fragment;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 place = texelFetch(places, at, 0);
    vec3 color = textureLod(base_color, place.xy, place.z).rgb;
    vec3 light = AMBIENT ? texelFetch(dark, at, 0).rgb + texelFetch(bright, at, 0).rgb * color
                         : color * place.w;
    fragment = vec4(srgb_encoded(developed(light)), 1.0);
}
