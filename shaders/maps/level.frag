// A texel of a MIP level as the mean of the two or three texels each way of the level before it
// that it covers, with the host's weights in the host's order (atlas/base/mip_chain.cpp): sums in
// float64, results rounded once. With GUTTERS there are two chains: means of all texels, and sums
// of the texels that show surface (colour times share, share). `level` is the mean in a level whose
// gutters count, and the mean of the surface alone in later levels.
uniform sampler2D before;          // means of the level before, or the texture itself
uniform sampler2D surface_before;  // surface sums of the level before, or the share in .r of the texture itself
uniform bool first;                // whether the level before is the texture itself
uniform bool gutters_count;
#if !EVEN
uniform ivec2 taps;  // texels of the level before that a new one covers: 1, 2 or 3 each way
#endif
layout(location = 0) out vec4 mean;
layout(location = 1) out vec4 surface;
layout(location = 2) out vec4 level;

// Weights, three for each new texel of an axis; where both axes are even (EVEN), all are quarters.
#if EVEN
#elif BURL_FLOAT64
uniform usamplerBuffer columns, rows;
double weight_of(usamplerBuffer weights, int i) { return packDouble2x32(texelFetch(weights, i).xy); }
#else
uniform samplerBuffer columns, rows;
float weight_of(samplerBuffer weights, int i) { return texelFetch(weights, i).r; }
#endif

vec4 surface_of(ivec2 p, vec4 color) {
    vec4 value = texelFetch(surface_before, p, 0);
    return first ? vec4(color.rgb * value.r, value.r) : value;
}

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    real3 color_sum = real3(0.0);
    real4 surface_sum = real4(0.0);
#if EVEN
    const ivec2 taps = ivec2(2);
    const real weight = real(0.25);
#endif
    for (int j = 0; j < taps.y; ++j) {
        for (int i = 0; i < taps.x; ++i) {
#if !EVEN
            real weight = weight_of(rows, 3 * p.y + j) * weight_of(columns, 3 * p.x + i);
#endif
            ivec2 old = 2 * p + ivec2(i, j);
            vec4 color = texelFetch(before, old, 0);
            exact real3 weighted = weight * real3(color.rgb);
            color_sum += weighted;
#if GUTTERS
            exact real4 weighted_surface = weight * real4(surface_of(old, color));
            surface_sum += weighted_surface;
#endif
        }
    }
    mean = vec4(vec3(color_sum), 1.0);
    surface = vec4(surface_sum);
    // A float64 quotient rounds to the float32 one, which OpenGL alone need not round rightly.
    level = gutters_count || surface.a <= 0.0 ? mean : vec4(vec3(real3(surface.rgb) / real(surface.a)), 1.0);
}
