// Numbers with their gradients with respect to the solid point, as in procedural/numbers/dual.h and
// procedural/graph/box_means.h: a real4 of the value and its derivatives along s, t and r. This
// part must follow graph/graph.glsl.

real4 dual(real constant) {
    return real4(constant, real3(0.0));
}

// The dot product in the host's order of additions.
real dot_of(real3 a, real3 b) {
    exact real sum = a.x * b.x + a.y * b.y + a.z * b.z;
    return sum;
}

real4 dual_product(real4 a, real4 b) {
    exact real4 product = real4(a.x * b.x, a.x * b.yzw + b.x * a.yzw);
    return product;
}

// The dual f(x) for f(x) = `value` and f'(x) = `derivative`; a derivative that is not finite counts
// as 0.
real4 dual_chain(real4 x, real value, real derivative) {
    exact real zero = derivative - derivative;
    exact real3 slope = derivative * x.yzw;
    return real4(value, zero == real(0.0) ? slope : real3(0.0));
}

// -2 / ln 2. (Literals without LF are float32 numbers; constants that float32 does not hold are
// written as quotients elsewhere.)
#if REAL_IS_DOUBLE
const double gaussian_falloff = -2.8853900817779268LF;
#else
const float gaussian_falloff = -2.8853900817779268;
#endif
real4 dual_sin(real4 x) {
    return dual_chain(x, sine(x.x), cosine(x.x));
}
real4 dual_abs(real4 x) {
    return x.x < real(0.0) ? -x : x;
}
real4 dual_min(real4 a, real4 b) {
    return b.x < a.x ? b : a;
}
real4 dual_max(real4 a, real4 b) {
    return a.x < b.x ? b : a;
}
real4 dual_floor(real4 x) {
    return dual(floor(x.x));
}
real4 dual_fract(real4 x) {
    return real4(fraction_of(x.x), x.yzw);
}

// x^e; a negative x counts as 0 where e is not whole.
real4 dual_power(real4 x, real e) {
    exact real derivative = e * power(x.x, e - real(1.0));
    return dual_chain(x, power(x.x, e), derivative);
}
real4 dual_whole_power(real4 x, uint e) {
    exact real derivative = real(float(e)) * whole_power(x.x, e - 1u);
    return dual_chain(x, whole_power(x.x, e), derivative);
}

real4 dual_smoothstep(real low, real high, real4 x) {
    if (x.x >= high || !(high > low)) return dual(x.x >= high ? real(1.0) : real(0.0));
    if (x.x <= low) return dual(real(0.0));
    exact real width = high - low, u = (x.x - low) / width;
    exact real4 curve = real4(u * u * (real(3.0) - real(2.0) * u),
                              real(6.0) * u * (real(1.0) - u) * (x.yzw / width));
    return curve;
}

real4 dual_length(real4 x, real4 y) {
    real far = length_of(x.x, y.x);
    exact real4 result = real4(far, (x.x / far) * x.yzw + (y.x / far) * y.yzw);
    return far > real(0.0) ? result : dual(far);
}

// The angle of (x, y). Its slope is continuous across the seam, and 0 at the origin.
real4 dual_angle(real4 y, real4 x) {
    real far = length_of(x.x, y.x);
    exact real4 result = real4(angle(unsigned_zero(y.x), x.x),
                               ((x.x / far) * y.yzw - (y.x / far) * x.yzw) / far);
    return far > real(0.0) ? result : dual(real(0.0));
}

real4 dual_lerp(real4 w, real4 a, real4 b) {
    exact real4 rest = dual(real(1.0)) - w;
    exact real4 sum = dual_product(rest, a) + dual_product(w, b);
    return sum;
}

// A noise at the point (x, y, z) as a dual, from its derivatives along the point's coordinates.
real4 dual_at(vec4 n, real4 x, real4 y, real4 z) {
    exact real3 slope = real(n.y) * x.yzw + real(n.z) * y.yzw + real(n.w) * z.yzw;
    return real4(real(n.x), slope);
}
real4 dual_at(real value, real3 gradient, real4 x, real4 y, real4 z) {
    exact real3 slope = gradient.x * x.yzw + gradient.y * y.yzw + gradient.z * z.yzw;
    return real4(value, slope);
}

// ---- Means over a box of values; width 0 gives the function itself ----

const real widest_box = real(1073741824.0);  // 2^30

// The length of odd cells in [0, u].
real odd_below(real u) {
    exact real pairs = floor(real(0.5) * u);
    exact real below = pairs + real(2.0) * max(real(0.5) * u - pairs - real(0.5), real(0.0));
    return below;
}
real4 box_odd(real4 x, real width) {
    if (!(width < widest_box)) return dual(real(0.5));
    exact real low = x.x - real(0.5) * width, high = x.x + real(0.5) * width;
    if (floor(low) == floor(high)) return dual(odd_cell(x.x));
    exact real start = real(2.0) * floor(real(0.5) * low);
    exact real share = (odd_below(high - start) - odd_below(low - start)) / width;
    exact real derivative = (odd_cell(high) - odd_cell(low)) / width;
    return dual_chain(x, share, derivative);
}

real4 box_fract(real4 x, real width) {
    if (!(width < widest_box)) return dual(real(0.5));
    exact real low = x.x - real(0.5) * width, high = x.x + real(0.5) * width;
    exact real cells = floor(high) - floor(low);
    if (cells == real(0.0)) return dual_fract(x);
    exact real from = low - floor(low), to = high - floor(high);
    exact real mean = real(0.5) * (cells + (to - from) * (to + from)) / width;
    exact real derivative = (to - from) / width;
    return dual_chain(x, mean, derivative);
}

// The share of the box where the fraction is at least a threshold.
real pulse_at(real x, real threshold) {
    exact real fraction = x - floor(x);
    return fraction >= threshold ? real(1.0) : real(0.0);
}
// The length of pulses in [0, u].
real pulse_below(real u, real threshold) {
    exact real below =
        floor(u) * (real(1.0) - threshold) + max(u - floor(u) - threshold, real(0.0));
    return below;
}
real4 box_pulse(real4 x, real width, real threshold) {
    if (!(width < widest_box)) return dual(real(1.0) - threshold);
    exact real low = x.x - real(0.5) * width, high = x.x + real(0.5) * width;
    real start = floor(low), first = pulse_at(low, threshold), last = pulse_at(high, threshold);
    if (start == floor(high) && first == last) return dual(pulse_at(x.x, threshold));
    exact real share =
        (pulse_below(high - start, threshold) - pulse_below(low - start, threshold)) / width;
    exact real derivative = (last - first) / width;
    return dual_chain(x, share, derivative);
}

// The share of the box that is not negative.
real4 box_step(real4 x, real width) {
    if (abs(x.x) >= real(0.5) * width || !(width > real(0.0)))
        return dual(x.x >= real(0.0) ? real(1.0) : real(0.0));
    exact real share = real(0.5) + x.x / width;
    return dual_chain(x, share, real(1.0) / width);
}

// The same; it fades to `mean` as the box widens from half of `widest` to `widest`.
real4 box_step(real4 x, real width, real mean, real widest) {
    real4 share = box_step(x, width);
    exact real begin = real(0.5) * widest;
    if (!(width > begin)) return share;
    return dual_lerp(dual(smooth_step(begin, widest, width)), share, dual(mean));
}

real4 box_sin(real4 x, real width) {
    exact real half_width = real(0.5) * width;
    if (!(half_width < widest_box)) return dual(real(0.0));
    exact real near = real(1.0) - half_width * half_width / real(6.0);
    exact real damping = half_width > real(1.0) / real(10000.0) ? sine(half_width) / half_width : near;
    exact real value = damping * sine(x.x), derivative = damping * cosine(x.x);
    return dual_chain(x, value, derivative);
}

// The mean of black minus white along one axis of a checkerboard over a box, whose half width is
// the longer of the moves u and v; 0 where that is above 1.
real4 stripes_over_box(real4 x, real u, real v) {
    exact real reach = max(abs(u), abs(v));
    exact real4 stripes = dual(real(1.0)) - real(2.0) * box_odd(x, real(2.0) * reach);
    return reach <= real(1.0) ? stripes : dual(real(0.0));
}
// The distance of the point from the border of a disk of the node `dots`, positive inside.
real4 dot_inside(real4 x, real4 y, DotDisk disk, real radius) {
    exact real4 dx = real4(disk.dx, x.yzw), dy = real4(disk.dy, y.yzw);
    exact real4 inside = dual(radius) - dual_length(dx, dy);
    return inside;
}

// ---- Fields: noise in a lattice, a quadric ----

// A gradient in a lattice, whose map from the solid has the columns a, b and c, as one in the
// solid.
real3 lattice_gradient(vec4 n, real3 a, real3 b, real3 c) {
    real3 along = real3(n.yzw);
    return real3(dot_of(a, along), dot_of(b, along), dot_of(c, along));
}

// Half the gradient of a quadric with the rows a, b, c and the linear part.
real3 half_gradient(real3 a, real3 b, real3 c, real3 linear, real3 at) {
    exact real3 half_of = real3(dot_of(a, at), dot_of(b, at), dot_of(c, at)) + linear;
    return half_of;
}

// z divided by a distance, and 0 where that is 0.
real4 dual_ratio(real4 z, real4 distance_of) {
    exact real inverse = real(1.0) / distance_of.x;
    exact real derivative = real(-1.0) / (distance_of.x * distance_of.x);
    real4 ratio = dual_product(z, dual_chain(distance_of, inverse, derivative));
    return distance_of.x > real(0.0) ? ratio : dual(real(0.0));
}

// The number of octaves that show where the point (x, y, z) moves across the footprint by its two
// steps: pbrt's -1 - log2(step), for a lacunarity of 2^grows.
real visible_octaves(real4 x, real4 y, real4 z, real3 step_u, real3 step_v, real grows,
                     real octaves) {
    real3 u = real3(dot_of(x.yzw, step_u), dot_of(y.yzw, step_u), dot_of(z.yzw, step_u)),
          v = real3(dot_of(x.yzw, step_v), dot_of(y.yzw, step_v), dot_of(z.yzw, step_v));
    real moved = max(nearest_root(dot_of(u, u)), nearest_root(dot_of(v, v)));
    if (!(moved > real(0.0)) || !(grows > real(0.0))) return octaves;
    exact real visible = (real(-1.0) - binary_log(moved)) / grows;
    return min(max(visible, real(0.0)), octaves);
}
