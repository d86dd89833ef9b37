// The noises without interpolation: one random number for each lattice cell, and for each cell of a
// lattice 2^16 times as fine (procedural/noise/value_noise.h). This part must follow
// noise/lattice.glsl.

float cell_noise(uint seed, uvec3 cell) {
    return lattice_value(lattice_bits(cell, seed));
}
float cell_noise(uint seed, uvec4 cell) {
    return lattice_value(lattice_bits(cell, seed));
}

// The cell in the finer lattice.
uint white_cell(uint cell, real place) {
    exact real fraction = place + real(0.5);
    return 65536u * cell +
           uint(float(floor(fraction * real(65536.0))));  // exact in float, because it is at most 65536
}
uvec3 white_cell(uvec3 cell, real3 place) {
    return uvec3(white_cell(cell.x, place.x), white_cell(cell.y, place.y),
                 white_cell(cell.z, place.z));
}

float white_noise(uint seed, uvec3 cell, real3 place) {
    return cell_noise(seed, white_cell(cell, place));
}
float white_noise(uint seed, uvec3 cell, real3 place, uint cell_w, real place_w) {
    return cell_noise(seed, uvec4(white_cell(cell, place), white_cell(cell_w, place_w)));
}
