#version 330 core
// A texture and its levels as the atlas view shows them: texels as squares where they are larger
// than a pixel, otherwise a level as coarse as the pixels, but no finer than `level`. Rows top
// first. This part must follow color/srgb_encode.glsl.
uniform sampler2D image;  // decoded to linear light by its format
uniform vec2 uv_low;      // uv of the target's corner
uniform vec2 uv_per_pixel;
uniform int level;  // finest level that is shown

out vec4 fragment;

void main() {
    vec2 uv = uv_low + uv_per_pixel * gl_FragCoord.xy;
    if (any(lessThan(uv, vec2(0.0))) || any(greaterThanEqual(uv, vec2(1.0)))) {
        fragment = vec4(vec3(0.22), 1.0);
        return;
    }
    ivec2 size = textureSize(image, 0);
    float width = log2(uv_per_pixel.x * float(size.x));  // width of a pixel, as a level
    vec3 color = width > float(level)
                     ? textureLod(image, uv, width).rgb
                     : texelFetch(image, ivec2(uv * vec2(textureSize(image, level))), level).rgb;
    fragment = vec4(srgb_encoded(color), 1.0);
}
