// A texel's point on its span's line, in a fragment shader drawn by spans (maps/span.glsl).
flat in int first_column;
flat in uint owner;
flat in uvec4 x_line, y_line, z_line;  // halves of float64 numbers: start and step

// The texel's number in its span.
double line_column() {
    return double(int(gl_FragCoord.x) - first_column);
}

double on_line(uvec4 line, double x) {
    precise double at = packDouble2x32(line.xy) + x * packDouble2x32(line.zw);
    return at;
}

dvec3 line_point() {
    double x = line_column();
    return dvec3(on_line(x_line, x), on_line(y_line, x), on_line(z_line, x));
}
