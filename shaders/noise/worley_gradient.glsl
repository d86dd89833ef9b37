// Worley's cellular noise with its gradient, which is 0 at a feature point. This part must follow
// noise/worley.glsl and noise/gradient.glsl.

vec4 worley_distance(float square, vec4 way) {
    float far = nearest_root(square);
    exact vec3 gradient = vec3(real3(way.xyz) / real(far));  // rounded to the nearest, by float64
    return vec4(far, square > 0.0 ? gradient : vec3(0.0));
}
vec4 worley_f1_sample(NearestFeatures nearest) {
    return worley_distance(nearest.square1, nearest.way1);
}
vec4 worley_f2_sample(NearestFeatures nearest) {
    return worley_distance(nearest.square2, nearest.way2);
}
vec4 worley_f2_f1_sample(NearestFeatures nearest) {
    exact vec4 difference = worley_f2_sample(nearest) - worley_f1_sample(nearest);
    return difference;
}
