// Colour maps averaged over a footprint, as in procedural/color/map_pieces.h and map_filter.cpp.
// This part must follow graph/dual.glsl and the arrays of pieces and breaks, which
// procedural/glsl/duals.cpp writes.

// A colour map: its pieces and breaks in the arrays, and its mean over a period.
struct PieceMap {
    int first, count, first_break, breaks;
    bool repeats;
    real3 mean;
};

real piece_index(PieceMap map, real f) {
    exact real t = f - floor(f);
    return !map.repeats ? f : t < real(1.0) ? t : real(0.0);
}
int piece_at(PieceMap map, real t) {
    int i = map.first;
    for (int k = 1; k < map.count; ++k) i += t >= piece_starts(map.first + k) ? 1 : 0;
    return i;
}

// Linear light of the piece that holds f, evaluated at g.
real3 extended_color(PieceMap map, real f, real g) {
    real t = piece_index(map, f);
    int i = piece_at(map, t);
    exact real3 color = map.mean + piece_colors(i) +
                        (t - piece_starts(i) + (g - f)) * piece_slopes(i);
    return color;
}
// The first antiderivative of the map less its mean.
real3 first_integral(PieceMap map, real f) {
    real t = piece_index(map, f);
    int i = piece_at(map, t);
    exact real x = t - piece_starts(i);
    exact real3 sum = piece_firsts(i) + x * (piece_colors(i) + x / real(2.0) * piece_slopes(i));
    return sum;
}
// The second antiderivative of the map less its mean.
real3 second_integral(PieceMap map, real f) {
    real t = piece_index(map, f);
    int i = piece_at(map, t);
    exact real x = t - piece_starts(i);
    exact real3 sum = piece_seconds(i) +
                      x * (piece_firsts(i) +
                           x * (piece_colors(i) / real(2.0) + x / real(6.0) * piece_slopes(i)));
    return sum;
}

// ---- Widths of a footprint, in f ----

struct PieceWidths {
    real wide, narrow;
};

PieceWidths widths_of(real along_u, real along_v) {
    real u = abs(along_u), v = abs(along_v);
    return PieceWidths(max(u, v), min(u, v));
}
// The side of the box of the same variance, as widths of one axis.
PieceWidths box_of(PieceWidths widths) {
    exact real ratio = widths.narrow / widths.wide;
    exact real box = widths.wide * nearest_root(real(1.0) + ratio * ratio);
    return PieceWidths(widths.wide > real(0.0) ? box : real(0.0), real(0.0));
}

// ---- Narrow footprints: the line at the low end, and what breaks add ----

// The means of the unit step at 0 and of the ramp max(x, 0), for x in [-sum / 2, 0].
real2 smoothed_below(real x, PieceWidths w) {
    exact real sum = real(0.5) * (w.wide + w.narrow), difference = real(0.5) * (w.wide - w.narrow);
    if (x <= -sum) return real2(0.0);
    exact real reach = x + sum;
    exact real outer = reach * reach / (real(2.0) * w.wide * w.narrow);
    exact real outer_ramp = outer * reach / real(3.0);
    if (x < -difference) return real2(outer, outer_ramp);
    exact real inner = real(0.5) + x / w.wide;
    exact real inner_ramp =
        (w.wide + w.narrow * (w.narrow / w.wide) / real(3.0)) / real(8.0) +
        x * (real(0.5) + x / (real(2.0) * w.wide));
    return real2(inner, inner_ramp);
}
// The means of the unit step at 0 and of the ramp max(x, 0), for any x.
real2 smoothed_break(real x, PieceWidths w) {
    real2 below = smoothed_below(-abs(x), w);
    exact real2 mirrored = real2(real(1.0) - below.x, x + below.y);
    return x <= real(0.0) ? below : mirrored;
}

real3 sum_over_breaks(PieceMap map, real t, PieceWidths w) {
    exact real reach = real(0.5) * (w.wide + w.narrow);
    exact real low = t - reach, high = t + reach;
    exact real first = map.repeats ? floor(low) : real(0.0);
    if (map.repeats && low - first >= real(1.0)) first = first + real(1.0);
    real last = map.repeats ? floor(high) : real(0.0);
    exact real start = low - first;
    exact real3 sum = extended_color(map, low, t);
    for (real period = first; period <= last; period += real(1.0))
        for (int k = 0; k < map.breaks; ++k) {
            real position = break_places(map.first_break + k);
            real beyond = map.repeats ? max(start, real(0.0)) : max(start, low);
            if (period == first && position <= beyond) continue;
            exact real away = t - (position + period);
            real2 step = smoothed_break(away, w);
            exact real3 jump = step.x * break_jumps(map.first_break + k),
                        kink = step.y * break_kinks(map.first_break + k);
            exact real3 both = jump + kink;
            sum = sum + both;
        }
    return sum;
}

// ---- Broad footprints: differences of antiderivatives, which cancel more in float32 ----

#if REAL_IS_DOUBLE
const real narrow_support = 0.015625LF;
#else
const real narrow_support = 2.0;
#endif

// The mean of c(f + wide U + narrow V), U and V uniform in [-1/2, 1/2].
real3 mean_color(PieceMap map, real f, PieceWidths widths) {
    exact real zero = (f - f) + (widths.wide - widths.wide);
    if (zero != real(0.0)) return extended_color(map, real(0.0), real(0.0));
    if (widths.wide == real(0.0)) return extended_color(map, f, f);
    exact real scale = min(real(1.0), real(1099511627776.0) / widths.wide);  // 2^40
    exact real part = f - floor(f), clamped = f * scale;
    real x = map.repeats ? part : clamped;
    PieceWidths w = widths;
    if (!map.repeats) w = PieceWidths(widths.wide * scale, widths.narrow * scale);
    exact real support = w.wide + w.narrow;
    exact real sum = real(0.5) * support, difference = real(0.5) * (w.wide - w.narrow);
    if (!map.repeats && (x - sum >= real(1.0) || x + sum <= real(0.0)))
        return extended_color(map, x, x);
    if (support < narrow_support || (w.narrow < (real(1.0) / real(1000.0)) * w.wide && support < real(2.0)))
        return sum_over_breaks(map, x, w);
    exact real3 result;
    if (w.narrow < (real(1.0) / real(1000.0)) * w.wide * (real(1.0) / real(1000.0))) {
        exact real half_wide = real(0.5) * w.wide;
        result = map.mean +
                 (first_integral(map, x + half_wide) - first_integral(map, x - half_wide)) / w.wide;
        return result;
    }
    exact real3 outer = second_integral(map, x + sum) + second_integral(map, x - sum);
    exact real3 inner = second_integral(map, x + difference) + second_integral(map, x - difference);
    result = map.mean + (outer - inner) / w.wide / w.narrow;
    return result;
}

// ---- Nodes ----

struct DualColor {
    real4 r, g, b;
};

// The map averaged over f, which changes by u and v across the footprint; over a box unless
// `both_axes`.
DualColor dual_color(PieceMap map, real4 f, real u, real v, bool both_axes) {
    exact real zero = f.x - f.x;
    real x = zero == real(0.0) ? f.x : real(0.0), width = length_of(u, v);
    PieceWidths widths = widths_of(u, v);
    if (!both_axes) widths = box_of(widths);
    real3 color = mean_color(map, x, widths);
    exact real3 derivative =
        extended_color(map, x, x + real(1.0)) - extended_color(map, x, x);
    exact real low = x - real(0.5) * width, high = x + real(0.5) * width;
    if (width > real(1.0) / real(1000000.0))
        derivative = (extended_color(map, high, high) - extended_color(map, low, low)) / width;
    return DualColor(dual_chain(f, color.r, derivative.r), dual_chain(f, color.g, derivative.g),
                     dual_chain(f, color.b, derivative.b));
}

// The mean of black minus white along one axis of a checkerboard over both of its moves, by the map
// of black and white stripes over half of x.
real4 stripes_over_both(PieceMap map, real4 x, real u, real v) {
    PieceWidths widths = widths_of(real(0.5) * u, real(0.5) * v);
    exact real width = real(2.0) * (widths.wide + widths.narrow), half_of = real(0.5) * x.x;
    real4 box = box_odd(x, width);
    bool edge = box.x > real(0.0) && box.x < real(1.0);
    real share = box.x;
    if (edge) share = mean_color(map, half_of, widths).r;
    exact real4 stripes = dual(real(1.0)) - real(2.0) * real4(share, box.yzw);
    return stripes;
}

#if REAL_IS_DOUBLE
uvec2 jitter_bits(real x) {
    return unpackDouble2x32(unsigned_zero(x));
}
#else
uvec2 jitter_bits(real x) {
    return uvec2(0u, floatBitsToUint(unsigned_zero(x)));
}
#endif

// A random number in [0, 1) from a point and a stratum of the footprint.
real stratum_jitter(real3 p, uint stratum) {
    uint h = prime_seed * (stratum + 1u);
    for (int axis = 0; axis < 3; ++axis) {
        uvec2 bits = jitter_bits(p[axis]);
        h = (h ^ bits.x) * 0x7feb352du;
        h ^= h >> 15;
        h = (h ^ bits.y) * 0x7feb352du;
        h ^= h >> 15;
    }
    h *= 0x846ca68bu;
    return real(h ^ h >> 16) * real(2.3283064365386962890625e-10);  // 2^-32
}

// The mean of a checkerboard in `axes` coordinates, which move by u and v across the footprint,
// over 4 x 4 strata weighted by a Gaussian.
real supersampled_board(real3 p, real3 u, real3 v, int axes) {
    exact real sum = real(0.0), weights = real(0.0);
    for (uint stratum = 0u; stratum < 16u; ++stratum) {
        exact real du = (real(stratum % 4u) + stratum_jitter(p, 2u * stratum)) / real(4.0) -
                        real(0.5);
        exact real dv = (real(stratum / 4u) + stratum_jitter(p, 2u * stratum + 1u)) / real(4.0) -
                        real(0.5);
        exact real3 q = p + du * u + dv * v;
        exact real sign = (real(1.0) - real(2.0) * odd_cell(q.x)) *
                          (real(1.0) - real(2.0) * odd_cell(q.y));
        if (axes == 3) sign = sign * (real(1.0) - real(2.0) * odd_cell(q.z));
        exact real exponent = (du * du + dv * dv) * gaussian_falloff;
        real weight = binary_power(exponent);
        sum = sum + weight * (real(0.5) - real(0.5) * sign);
        weights = weights + weight;
    }
    return sum / weights;
}

// The spline of marble over t in [0, 1]: Bernstein's weights of four neighbouring points, or those
// of the uniform cubic B-spline.
DualColor dual_spline(real4 t, bool b_spline) {
    exact real at = floor(t.x * real(6.0));
    int first = int(min(max(at, real(0.0)), real(5.0)));
    exact real4 u = real(6.0) * t - dual(real(first)), v = dual(real(1.0)) - u;
    real4 u3 = dual_product(dual_product(u, u), u), v3 = dual_product(dual_product(v, v), v);
    real4 w0 = v3, w1 = dual_product(dual_product(real(3.0) * u, v), v),
          w2 = dual_product(dual_product(real(3.0) * u, u), v), w3 = u3;
    if (b_spline) {
        exact real4 b = dual(real(4.0)) - dual_product(real(6.0) * u, u) + real(3.0) * u3,
                    c = dual(real(4.0)) - dual_product(real(6.0) * v, v) + real(3.0) * v3;
        const real sixth = real(1.0) / real(6.0);
        w0 = sixth * v3;
        w1 = sixth * b;
        w2 = sixth * c;
        w3 = sixth * u3;
    }
    real3 p0 = marble_points(first), p1 = marble_points(first + 1), p2 = marble_points(first + 2),
          p3 = marble_points(first + 3);
    exact real4 r = p0.r * w0 + p1.r * w1 + p2.r * w2 + p3.r * w3;
    exact real4 g = p0.g * w0 + p1.g * w1 + p2.g * w2 + p3.g * w3;
    exact real4 b = p0.b * w0 + p1.b * w1 + p2.b * w2 + p3.b * w3;
    return DualColor(r, g, b);
}

// ---- Octaves that a footprint cannot show ----

// The share of an octave that shows where the footprint's sides in its lattice are u and v
// (procedural/model/band_limit.h).
real band_weight(real3 u, real3 v) {
    real squared = max(dot_of(u, u), dot_of(v, v));
    if (squared < real(9.0) / real(100.0)) return real(1.0);
    if (!(squared < real(17.0) / real(100.0))) return real(0.0);
    exact real left = real(-1.0) - real(0.5) * binary_log(squared);
    exact real x = min(max((left - real(3.0) / real(10.0)) / (real(2.0) / real(5.0)), real(0.0)), real(1.0));
    exact real weight = x * x * (real(3.0) - real(2.0) * x);
    return weight;
}
