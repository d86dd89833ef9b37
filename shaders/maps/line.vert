// The line of points that a span's texels show, mapped. This part must follow maps/span.glsl;
// maps/line.glsl reads it.
uniform dmat3 line_linear;
uniform dvec3 line_offset;
uniform double line_limit;  // a coordinate that reaches this size on the span is 0 on all of it; 0: no limit

flat out uvec4 x_line, y_line, z_line;

uvec4 halves(double a, double b) {
    return uvec4(unpackDouble2x32(a), unpackDouble2x32(b));
}

void main() {
    SpanLine line = span_line();
    precise dvec3 start = along(line_linear, line.start) + line_offset, step = along(line_linear, line.step);
    if (line_limit > 0.0lf) {
        precise dvec3 reach = abs(start) + double(span.y) * abs(step);
        bvec3 inside = lessThan(reach, dvec3(line_limit));
        start = mix(dvec3(0.0lf), start, inside), step = mix(dvec3(0.0lf), step, inside);
    }
    x_line = halves(start.x, step.x), y_line = halves(start.y, step.y), z_line = halves(start.z, step.z);
    place_span();
}
