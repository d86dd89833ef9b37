// What the screen shows of linear light before it is encoded, as developed() of app/light/tone.h.
uniform float exposure;  // factor of light

// Macro TONE: the curve is applied (Khronos PBR Neutral).
vec3 tone_mapped(vec3 light) {
    float darkest = min(min(light.r, light.g), light.b);
    vec3 color = light - (darkest < 0.08 ? darkest - 6.25 * darkest * darkest : 0.04);
    float peak = max(max(color.r, color.g), color.b);
    if (peak <= 0.76) return color;
    float mapped = 1.0 - 0.24 * 0.24 / (peak + 0.24 - 0.76);
    float kept = 1.0 / (0.15 * (peak - mapped) + 1.0);
    return mix(vec3(mapped), color * mapped / peak, kept);
}

vec3 developed(vec3 light) {
    return TONE ? tone_mapped(exposure * light) : exposure * light;
}
