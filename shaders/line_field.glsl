// Quadric and lattice coordinates at points of a texel's line (texel_line.glsl), as the host's kernels work them out.
// After stream_noise.glsl.
uniform real quadric[10];  // a to j of procedural/texture.h

// evaluate_quadric.
real quadric_at(real3 p) {
    exact real3 half_gradient =
        real3(quadric[0] * p.x + quadric[1] * p.y + quadric[2] * p.z + quadric[3],
              quadric[1] * p.x + quadric[4] * p.y + quadric[5] * p.z + quadric[6],
              quadric[2] * p.x + quadric[5] * p.y + quadric[7] * p.z + quadric[8]);
    exact real q = (p.x * half_gradient.x + p.y * half_gradient.y + p.z * half_gradient.z) +
                   (quadric[3] * p.x + quadric[6] * p.y + quadric[8] * p.z) + quadric[9];
    return q;
}

// A texel's side in a lattice; half of lattice_limit or more (or NaN) counts as 0.
real3 lattice_side(real3 side) {
    return real3(abs(side.x) < real(0.5) * lattice_limit ? side.x : real(0.0),
                 abs(side.y) < real(0.5) * lattice_limit ? side.y : real(0.0),
                 abs(side.z) < real(0.5) * lattice_limit ? side.z : real(0.0));
}

// Of an octave without a stream (procedural/field_sampler.cpp): where the line of all the span's texels reaches the
// limit it stays at 0, and so does a step to the next row.
TexelLine in_lattice(TexelLine line) {
    exact real3 reach = abs(line.start) + line.count * abs(line.step);
    for (int axis = 0; axis < 3; ++axis) {
        if (!(reach[axis] < lattice_limit)) line.start[axis] = line.step[axis] = real(0.0);
        if (!(abs(line.down[axis]) < lattice_limit)) line.down[axis] = real(0.0);
    }
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

// A site moved by less than 2^51 cells.
StreamSite moved(StreamSite site, real3 by) {
    uvec2 x = fixed_point(by.x), y = fixed_point(by.y), z = fixed_point(by.z);
    uvec3 place = site.place + uvec3(x.y, y.y, z.y);
    return StreamSite(site.cell + uvec3(x.x, y.x, z.x) + uvec3(lessThan(place, site.place)), place);
}

// Along u and v, in texels.
StreamSite moved(StreamSite site, real3 u, real3 v, real2 offset) {
    exact real3 by = offset.x * u + offset.y * v;
    return moved(site, by);
}
