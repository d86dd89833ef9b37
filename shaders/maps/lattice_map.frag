// A texel of a lattice map (procedural/field/lattice_map.h), with the host's bits. This part must
// follow maps/line.glsl.
uniform double period;

flat in uvec4 cells;
flat in uvec4 parabola;
flat in uvec2 parabola_turn;

layout(location = 0) out uvec4 map_cells;   // cells along x, y and z, upper half of q
layout(location = 1) out uvec4 map_places;  // places in the cells in units of 2^-32, lower half of q

// Cell and place of a coordinate that is not in fixed point yet.
uvec2 split(double x) {
    double cell = floor(x);
    precise double wrapped = cell;
    if (period > 0.0lf) wrapped = cell - period * floor(cell / period);
    precise double shifted = wrapped + 6755399441055744.0lf;      // 1.5 2^52
    precise double place = floor((x - cell) * 4294967296.0lf);    // 2^32 where x - cell rounds to 1
    precise double shifted_place = place + 4503599627370496.0lf;  // 2^52
    return uvec2(unpackDouble2x32(shifted).x + uint(place >= 4294967296.0lf), unpackDouble2x32(shifted_place).x);
}

void main() {
    double x = line_column();
    dvec3 at = line_point();
    uvec2 on_x, on_y, on_z;
    if (cells.w != 0u) {
        on_x = split(at.x), on_y = split(at.y), on_z = split(at.z);
    } else {
        on_x = unpackDouble2x32(at.x).yx, on_y = unpackDouble2x32(at.y).yx, on_z = unpackDouble2x32(at.z).yx;
        on_x.x += cells.x, on_y.x += cells.y, on_z.x += cells.z;
    }
    precise double slope = packDouble2x32(parabola.zw) + x * packDouble2x32(parabola_turn);
    precise double q = packDouble2x32(parabola.xy) + x * slope;
    uvec2 q_halves = unpackDouble2x32(q);
    map_cells = uvec4(on_x.x, on_y.x, on_z.x, q_halves.y);
    map_places = uvec4(on_x.y, on_y.y, on_z.y, q_halves.x);
}
