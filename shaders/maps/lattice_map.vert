// The spans of a lattice map (procedural/field/lattice_map.h): the numbers, constant along a span,
// of the coordinates that fill_stream computes and of the parabola that make_parabolas computes.
// This part must follow maps/span.glsl.
uniform dmat3 lattice_linear;
uniform dvec3 lattice_offset;
uniform double coordinate_limit;    // a coordinate that reaches this size is 0 on the span
uniform double period, per_period;  // period of the cells, and 1 / period; 0 for 2^32
uniform dmat3 quadric;              // the quadric's symmetric matrix
uniform dvec3 quadric_slope;        // the quadric's coefficients d, g and i
uniform double quadric_constant;

// Halves of float64 numbers. Along an axis, texel j has the bits of from + j step, plus the cell;
// on hard lines, for which fixed point has no room, its coordinate is from + j step itself.
flat out uvec4 x_line, y_line, z_line;  // from, step
flat out uvec4 cells;                   // cells along x, y and z, and whether the line is hard
flat out uvec4 parabola;                // c0, c1
flat out uvec2 parabola_turn;           // c2

const double round_magic = 6755399441055744.0lf;  // 1.5 2^52
const double fixed_magic = 1572864.0lf;           // 1.5 2^20
const double fixed_reach = 262144.0lf;            // 2^18

uvec4 halves(double a, double b) {
    return uvec4(unpackDouble2x32(a), unpackDouble2x32(b));
}

void map_stream(SpanLine line) {
    precise dvec3 start = along(lattice_linear, line.start) + lattice_offset, step = along(lattice_linear, line.step);
    precise dvec3 extent = double(span.y) * abs(step), reach = abs(start) + extent;
    bvec3 inside = lessThan(reach, dvec3(coordinate_limit));
    bool hard = !(all(inside) && all(lessThan(extent, dvec3(fixed_reach))));
    if (hard) {
        start = mix(dvec3(0.0lf), start, inside), step = mix(dvec3(0.0lf), step, inside);
        cells = uvec4(0u, 0u, 0u, 1u);
    } else {
        if (period > 0.0lf) {
            precise dvec3 periods = (start * per_period + round_magic) - round_magic;
            start = start - periods * period;
        }
        precise dvec3 shifted = start + round_magic;
        precise dvec3 rest = start - (shifted - round_magic);
        cells = uvec4(unpackDouble2x32(shifted.x).x, unpackDouble2x32(shifted.y).x, unpackDouble2x32(shifted.z).x, 0u);
        cells.xyz -= unpackDouble2x32(fixed_magic).y;
        start = rest + fixed_magic;
    }
    x_line = halves(start.x, step.x), y_line = halves(start.y, step.y), z_line = halves(start.z, step.z);
}

void map_quadric(SpanLine line) {
    dvec3 half_gradient = along(quadric, line.start);
    precise dvec3 twice = half_gradient + 2.0lf * quadric_slope, once = half_gradient + quadric_slope;
    precise double value = dot_product(twice, line.start) + quadric_constant;
    precise double slope = 2.0lf * dot_product(once, line.step);
    double turn = dot_product(along(quadric, line.step), line.step);
    parabola = halves(value, slope);
    parabola_turn = unpackDouble2x32(turn);
}

void main() {
    SpanLine line = span_line();
    map_stream(line);
    map_quadric(line);
    place_span();
}
