// The side of the box of the same variance as a texel's footprint, whose sides are `wide` >=
// `narrow` >= 0: FilterWidths of procedural/color/map_filter.h. This part must follow
// numbers/real.glsl.
real box_width(real wide, real narrow) {
    exact real ratio = narrow / wide;
    exact real box = wide * nearest_root(real(1.0) + ratio * ratio);
    return wide > real(0.0) ? box : real(0.0);
}
