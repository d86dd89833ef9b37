#version 330 core
// A texture and its levels as the atlas view shows them: texels as squares where they are larger
// than a pixel, otherwise a level as coarse as the pixels, but no finer than `level`. Rows top
// first.
uniform sampler2D image;  // decoded to linear light by its format
uniform vec2 uv_low;      // uv of the target's corner
uniform vec2 uv_per_pixel;
uniform int level;  // finest level that is shown

out vec4 fragment;

vec3 encoded(vec3 linear) {
    vec3 c = clamp(linear, 0.0, 1.0);
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThan(c, vec3(0.0031308)));
}

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
    fragment = vec4(encoded(color), 1.0);
}
