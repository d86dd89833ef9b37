// A texture graph's colour as the weighted mean of several samples in the texel, as in
// procedural/fill/graph_points.h. This part must follow texture_color, maps/texel_line.glsl and
// maps/supersample.glsl.
uniform real3 texture_from_atlas[4];  // three columns and the offset

real3 mean_color(ivec2 texel) {
    TexelLine line;
    if (!texel_line(texel, line)) return texture_color(real3(0.0));
    line = mapped(line, texture_from_atlas[0], texture_from_atlas[1], texture_from_atlas[2], texture_from_atlas[3]);
    exact real3 sum = real3(0.0);
    exact real weights = real(0.0);
    for (int i = 0; i < sample_count; ++i) {
        real2 offset = sample_offset(i, texel + tile_origin);
        real weight = gaussian_weight(offset);
        sum = sum + weight * texture_color(line_point(line, offset));
        weights = weights + weight;
    }
    exact real3 mean = sum / weights;
    return mean;
}
