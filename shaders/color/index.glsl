// The colour map's index of a field value, as map_index in procedural/color/table.h: modulo one in
// [0, 1), or clamped to [0, 1]; 0 for NaN. This part must follow numbers/real.glsl. COLOR_REPEATS
// is 1 or 0.
#if COLOR_REPEATS
real color_index(real f) {
    exact real part = f - floor(f);
    return part < real(1.0) ? part : real(0.0);
}
#else
real color_index(real f) {
    real positive = f > real(0.0) ? f : real(0.0);
    return positive < real(1.0) ? positive : real(1.0);
}
#endif
