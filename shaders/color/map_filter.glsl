// The colour map's mean over a footprint, in linear light, as the sum of the shares of the map's
// breaks: the closed forms of procedural/color/map_filter_kernels.cpp in their sequence of
// operations. A break adds its jump and its kink times its shares (jump, kink). This part must
// follow color/box_width.glsl; COLOR_REPEATS (color/index.glsl) chooses the basis.

// A basis has the antiderivatives of a unit jump and a unit kink at `position`, up to terms that
// differences cancel.
#if COLOR_REPEATS
// The periodic basis: -B_k(u) / k! of the distance u = y + 1/2 from the break, B_k being
// Bernoulli's polynomials.
real break_distance(real x, real position) {
    exact real z = x - (position + real(0.5));
    exact real y = z - roundEven(z);
    return y;
}
real break_cubic(real y, real square) {
    exact real cubic = y * (real(1.0) / real(24.0) - square * (real(1.0) / real(6.0)));
    return cubic;
}
real2 break_first(real x, real position) {
    real y = break_distance(x, position);
    exact real square = y * y;
    return real2(square * real(-0.5), break_cubic(y, square));
}
real2 break_second(real x, real position) {
    real y = break_distance(x, position);
    exact real square = y * y;
    exact real quartic = square * (real(1.0) / real(48.0) - square * (real(1.0) / real(24.0)));
    return real2(break_cubic(y, square), quartic);
}
// The unit jump and the unit kink themselves.
real2 break_value(real x, real position) {
    real y = break_distance(x, position);
    exact real kink = real(1.0) / real(24.0) - (y * y) * real(0.5);
    return real2(-y, kink);
}
// The distance to the nearest break, negative where x lies to its left.
real break_side(real x, real position) {
    real y = break_distance(x, position);
    exact real size = real(0.5) - abs(y);
    return y < real(0.0) ? size : -size;
}
#else
// The clamped basis: powers of x - position to the right of the break. Beyond 1, where all kinks of
// a map cancel, the kink's powers go on without the highest.
real2 break_first(real x, real position) {
    exact real all = max(x - position, real(0.0));
    exact real within = max(min(x, real(1.0)) - position, real(0.0));
    exact real rest = max(x - real(1.0), real(0.0));
    exact real kink = within * (within * real(0.5) + rest);
    return real2(all, kink);
}
real2 break_second(real x, real position) {
    exact real all = max(x - position, real(0.0));
    exact real within = max(min(x, real(1.0)) - position, real(0.0));
    exact real rest = max(x - real(1.0), real(0.0));
    exact real square = (within * within) * (within * (real(1.0) / real(6.0)) + rest * real(0.5));
    exact real kink = square + within * ((rest * rest) * real(0.5));
    exact real jump = (all * all) * real(0.5);
    return real2(jump, kink);
}
real2 break_value(real x, real position) {
    exact real within = max(min(x, real(1.0)) - position, real(0.0));
    return real2(x >= position ? real(1.0) : real(0.0), within);
}
real break_side(real x, real position) {
    exact real side = x - position;
    return side;
}
#endif

// The values of f over a texel: their middle and their changes along the texel's sides, `wide` >=
// `narrow` >= 0.
struct Footprint {
    real f, wide, narrow;
};

real2 box_shares(Footprint at, real position) {
    exact real half_wide = at.wide * real(0.5);
    exact real low = at.f - half_wide, high = at.f + half_wide;
    exact real2 shares = break_first(high, position) - break_first(low, position);
    return shares;
}
real box_scale(Footprint at) {
    return real(1.0) / at.wide;
}

real2 trapezoid_shares(Footprint at, real position) {
    exact real sum = (at.wide + at.narrow) * real(0.5);
    exact real difference = (at.wide - at.narrow) * real(0.5);
    exact real outer_low = at.f - sum, outer_high = at.f + sum;
    exact real inner_low = at.f - difference, inner_high = at.f + difference;
    exact real2 high = break_second(outer_high, position) - break_second(inner_high, position);
    exact real2 low = break_second(inner_low, position) - break_second(outer_low, position);
    exact real2 shares = high - low;
    return shares;
}
real trapezoid_scale(Footprint at) {
    exact real scale = real(1.0) / (at.wide * at.narrow);
    return scale;
}

// The map at f, plus the correction of a break inside the footprint: the smoothed step and ramp
// less the sharp ones.
real2 narrow_shares(Footprint at, real position) {
    exact real support = (at.wide + at.narrow) * real(0.5),
               flat_part = (at.wide - at.narrow) * real(0.5);
    exact real per_wide = real(1.0) / at.wide;
    exact real slant = real(1.0) / (real(2.0) * (at.wide * at.narrow));
    exact real ratio = at.narrow * (at.narrow * per_wide);
    exact real top = (at.wide + ratio / real(3.0)) * real(0.125);
    real side = break_side(at.f, position), away = abs(side);
    exact real reach = support - away;
    exact real outer = (reach * reach) * slant, inner = real(0.5) - away * per_wide;
    exact real outer_ramp = (outer * reach) * (real(1.0) / real(3.0));
    exact real middle = real(0.5) - (away * per_wide) * real(0.5);
    exact real inner_ramp = top - away * middle;
    bool sloping = away >= flat_part, inside = reach > real(0.0);
    real step = sloping ? outer : inner, ramp = sloping ? outer_ramp : inner_ramp;
    exact real2 shares =
        break_value(at.f, position) -
        real2(inside ? (side < real(0.0) ? -step : step) : real(0.0), inside ? -ramp : real(0.0));
    return shares;
}
real narrow_scale(Footprint at) {
    return real(1.0);
}

// ---- Which form suits a footprint (procedural/field/stream_filter.cpp) ----

// The footprint of a texel; the box of the same variance unless `both_axes`. Its sides are 0 where
// f or a slope is not finite.
Footprint footprint_of(real f, vec2 slopes, bool both_axes) {
    real u = abs(real(slopes.x)), v = abs(real(slopes.y));
    real wide = max(u, v), narrow = min(u, v);
    exact real total = f + wide + narrow;
    if (isnan(total) || isinf(total)) wide = narrow = real(0.0);
    if (both_axes) return Footprint(f, wide, narrow);
    return Footprint(f, box_width(wide, narrow), real(0.0));
}

// The method for a footprint: 1 narrow, 2 box, 3 trapezoid. In float32, differences of the broad
// methods cancel more, so the narrow one goes further.
#if REAL_IS_DOUBLE
#define NARROW_SUPPORT 0.015625
#else
#define NARROW_SUPPORT 0.49
#endif
int method_for(Footprint at) {
    real support = at.wide + at.narrow;
    if (!(support >= real(NARROW_SUPPORT))) return 1;
    if (at.narrow < at.wide * real(1.0) / real(1000000.0)) return 2;
    return at.narrow < at.wide / real(1000.0) && support < real(0.5) ? 1 : 3;
}

// The footprint in the range of the formulas: f so that adding half a width rounds nothing off it,
// and widths up to the one that is as good as infinite.
Footprint reduced(Footprint at) {
#if COLOR_REPEATS
    const real widest = real(1073741824.0);  // 2^30
#else
    const real widest = real(1099511627776.0);  // 2^40
#endif
    real x = isnan(at.f) || isinf(at.f) ? real(0.0) : at.f;
    if (at.wide > widest) {
        exact real scale = widest / at.wide;
        at.wide = widest;
        at.narrow *= scale;
#if !COLOR_REPEATS
        x *= scale;
#endif
    }
#if COLOR_REPEATS
    exact real part = x - floor(x);
    at.f = part;
#else
    exact real half_support = real(0.5) * (at.wide + at.narrow);
    at.f = min(max(x, -half_support), real(1.0) + half_support);
#endif
    return at;
}
