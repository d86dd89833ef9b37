// Quadric and lattice coordinates at points of a texel's line (maps/texel_line.glsl), with the
// arithmetic of the host's kernels. This part must follow noise/stream_noise.glsl.
uniform real quadric[10];  // coefficients a to j of procedural/model/texture.h

// The quadric at p, as evaluate_quadric computes it.
real quadric_at(real3 p) {
    exact real3 half_gradient =
        real3(quadric[0] * p.x + quadric[1] * p.y + quadric[2] * p.z + quadric[3],
              quadric[1] * p.x + quadric[4] * p.y + quadric[5] * p.z + quadric[6],
              quadric[2] * p.x + quadric[5] * p.y + quadric[7] * p.z + quadric[8]);
    exact real q = (p.x * half_gradient.x + p.y * half_gradient.y + p.z * half_gradient.z) +
                   (quadric[3] * p.x + quadric[6] * p.y + quadric[8] * p.z) + quadric[9];
    return q;
}

// A texel's side in a lattice; components of half of lattice_limit or more (or NaN) count as 0.
real3 lattice_side(real3 side) {
    return real3(abs(side.x) < real(0.5) * lattice_limit ? side.x : real(0.0),
                 abs(side.y) < real(0.5) * lattice_limit ? side.y : real(0.0),
                 abs(side.z) < real(0.5) * lattice_limit ? side.z : real(0.0));
}

// The line of an octave without a stream kernel (procedural/field/sampler.cpp): a coordinate that
// reaches the limit on any of the span's texels is 0 on all of them, and so is a step to the next
// row that reaches it.
TexelLine in_lattice(TexelLine line) {
    exact real3 reach = abs(line.start) + line.count * abs(line.step);
    bvec3 inside = lessThan(reach, real3(lattice_limit));
    line.start = mix(real3(0.0), line.start, inside);
    line.step = mix(real3(0.0), line.step, inside);
    line.down = mix(real3(0.0), line.down, lessThan(abs(line.down), real3(lattice_limit)));
    return line;
}

// x in 32.32 fixed point: cell, place.
uvec2 fixed_point(real x) {
#if REAL_IS_DOUBLE
    exact double shifted = x + 6755399441055744.0lf;  // 1.5 2^52: to the nearest whole number
    exact double rest = x - (shifted - 6755399441055744.0lf);
    exact double sum = rest + 1572864.0lf;  // 1.5 2^20, about which numbers are 2^-32 apart
    uvec2 bits = unpackDouble2x32(sum);
    return uvec2(unpackDouble2x32(shifted).x + bits.y - 0x41380000u, bits.x);
#else
    float cell = floor(x);
    return uvec2(uint(int(cell)), uint(min(x - cell, 0.99999994) * 4294967296.0));
#endif
}

// A site moved by `by`, less than 2^51 cells along each axis.
StreamSite moved(StreamSite site, real3 by) {
    uvec2 x = fixed_point(by.x), y = fixed_point(by.y), z = fixed_point(by.z);
    uvec3 place = site.place + uvec3(x.y, y.y, z.y);
    return StreamSite(site.cell + uvec3(x.x, y.x, z.x) + uvec3(lessThan(place, site.place)), place);
}

// A site moved by an offset along u and v, in texels.
StreamSite moved(StreamSite site, real3 u, real3 v, real2 offset) {
    exact real3 by = offset.x * u + offset.y * v;
    return moved(site, by);
}

real dot_product(real3 a, real3 b) {
    exact real sum = a.x * b.x + a.y * b.y + a.z * b.z;
    return sum;
}

// The quadric's matrix times v.
real3 curved(real3 v) {
    exact real3 product = real3(quadric[0] * v.x + quadric[1] * v.y + quadric[2] * v.z,
                                quadric[1] * v.x + quadric[4] * v.y + quadric[5] * v.z,
                                quadric[2] * v.x + quadric[5] * v.y + quadric[7] * v.z);
    return product;
}

// The quadric at start + x step by the parabola of procedural/kernels/quadric_kernel.cpp.
real parabola_at(real3 start, real3 step, real x) {
    real3 half_gradient = curved(start), linear = real3(quadric[3], quadric[6], quadric[8]);
    exact real3 twice = half_gradient + real(2.0) * linear, once = half_gradient + linear;
    exact real value = dot_product(twice, start) + quadric[9];
    exact real slope = real(2.0) * dot_product(once, step);
    real turn = dot_product(curved(step), step);
    exact real q = value + x * (slope + x * turn);
    return q;
}

#if REAL_IS_DOUBLE
// Cell and place of a coordinate out of reach of fixed point, as in FillHardLine of
// procedural/kernels/stream_kernels.cpp.
uvec2 split(double x, double period) {
    double cell = floor(x);
    exact double wrapped = cell;
    if (period > 0.0lf) wrapped = cell - period * floor(cell / period);
    exact double place = floor((x - cell) * 4294967296.0lf);  // 2^32 where x - cell rounds to 1
    exact double shifted_place = place + 4503599627370496.0lf;
    return uvec2(low_bits(wrapped) + (place >= 4294967296.0lf ? 1u : 0u), unpackDouble2x32(shifted_place).x);
}

// Cell and place at start + x step along one axis; `near` where the coordinate stays within its
// limit, `hard` where the line is out of reach of fixed point. (By axis, since NVIDIA's compiler
// links no write to a vector's component by a variable.)
uvec2 site_on_axis(double start, double step, double x, double period, bool near, bool hard) {
    exact double at = near ? start + x * step : 0.0lf;
    if (hard) return split(at, period);
    if (period > 0.0lf) {
        exact double periods = (start * (1.0lf / period) + 6755399441055744.0lf) - 6755399441055744.0lf;
        exact double wrapped = start - periods * period;
        start = wrapped;
    }
    exact double shifted = start + 6755399441055744.0lf;                           // 1.5 2^52
    exact double from = (start - (shifted - 6755399441055744.0lf)) + 1572864.0lf;  // 1.5 2^20
    exact double fixed_point_sum = from + x * step;
    uvec2 bits = unpackDouble2x32(fixed_point_sum);
    return uvec2(unpackDouble2x32(shifted).x + bits.y - 0x41380000u, bits.x);
}
#endif

// The site of texel x of a line that is `count` texels long and mapped to a lattice, as fill_stream
// computes it. A coordinate that reaches limits.x on the line is 0 on all of it; limits.y is the
// period of the cells, 0 for 2^32.
StreamSite stream_site(TexelLine line, real x, real2 limits) {
#if REAL_IS_DOUBLE
    exact dvec3 extent = line.count * abs(line.step), reach = abs(line.start) + extent;
    bvec3 near = lessThan(reach, dvec3(limits.x));
    bool hard = !(all(near) && all(lessThan(extent, dvec3(262144.0lf))));  // 2^18
    uvec2 on_x = site_on_axis(line.start.x, line.step.x, x, limits.y, near.x, hard),
          on_y = site_on_axis(line.start.y, line.step.y, x, limits.y, near.y, hard),
          on_z = site_on_axis(line.start.z, line.step.z, x, limits.y, near.z, hard);
    return StreamSite(uvec3(on_x.x, on_y.x, on_z.x), uvec3(on_x.y, on_y.y, on_z.y));
#else
    vec3 at = line.start + x * line.step;
    uvec2 on_x = fixed_point(at.x), on_y = fixed_point(at.y), on_z = fixed_point(at.z);
    return StreamSite(uvec3(on_x.x, on_y.x, on_z.x), uvec3(on_x.y, on_y.y, on_z.y));
#endif
}

// The row of a texel's corners `side` rows below its centre: one texel longer than the span, from
// half a step before it on (procedural/field/corner_samples.cpp).
TexelLine corner_line(TexelLine line, real side) {
    exact real3 start = line.start - real(0.5) * line.step + side * line.down;
    return TexelLine(start, line.step, line.down, line.column, line.count + real(1.0), line.owner);
}
