// Worley's cellular noise: the exact distance to the nearest of random points, one in each cell, in
// three and four dimensions (procedural/noise/worley_noise.h). A loop begins beyond its end where
// no point can be nearer: graphics processors and llvmpipe then skip it, where they would execute a
// branch for all. This part must follow noise/lattice.glsl.

// Squared distances of the two nearest feature points so far, and the vectors from them to the
// point.
struct NearestFeatures {
    float square1, square2;
    vec4 way1, way2;
};

void keep_nearest(float square, vec4 way, inout NearestFeatures nearest) {
    if (square < nearest.square1) {
        nearest.square2 = nearest.square1;
        nearest.way2 = nearest.way1;
        nearest.square1 = square;
        nearest.way1 = way;
    } else if (square < nearest.square2) {
        nearest.square2 = square;
        nearest.way2 = way;
    }
}

// A component of a feature point's place in its cell, from the cell's hash.
float feature_place(uint h, uint axis) {
    return float(mix_bits(h + axis * prime_seed) >> 8) * 5.9604644775390625e-8;  // 2^-24
}

// The squared distance along an axis of a place to the cell that lies `steps` away.
float gap_square(float place, int steps) {
    exact float gap = abs(float(steps) - place) - 0.5;
    return steps == 0 ? 0.0 : gap * gap;
}

// The component of the vector from a feature point in the cell that lies `steps` away to the place.
float feature_way(float place, float feature, int steps) {
    exact float way = place - ((feature - 0.5) + float(steps));
    return way;
}

void visit_feature(uint seed, uvec3 cell, vec3 place, uvec3 period, ivec3 steps,
                   inout NearestFeatures nearest) {
    exact float border =
        gap_square(place.x, steps.x) + gap_square(place.y, steps.y) + gap_square(place.z, steps.z);
    uint h = lattice_bits(lattice_index(cell, steps, period), seed);
    vec3 way = vec3(feature_way(place.x, feature_place(h, 0u), steps.x),
                    feature_way(place.y, feature_place(h, 1u), steps.y),
                    feature_way(place.z, feature_place(h, 2u), steps.z));
    float square = exact_dot(way, way);
    if (border < nearest.square2) keep_nearest(square, vec4(way, 0.0), nearest);
}

void visit_feature(uint seed, uvec4 cell, vec4 place, uvec4 period, ivec4 steps,
                   inout NearestFeatures nearest) {
    exact float border = gap_square(place.x, steps.x) + gap_square(place.y, steps.y) +
                         gap_square(place.z, steps.z) + gap_square(place.w, steps.w);
    uint h = lattice_bits(lattice_index(cell, steps, period), seed);
    vec4 way = vec4(feature_way(place.x, feature_place(h, 0u), steps.x),
                    feature_way(place.y, feature_place(h, 1u), steps.y),
                    feature_way(place.z, feature_place(h, 2u), steps.z),
                    feature_way(place.w, feature_place(h, 3u), steps.w));
    exact float square = exact_dot(way.xyz, way.xyz) + way.w * way.w;
    if (border < nearest.square2) keep_nearest(square, way, nearest);
}

// The i-th of the (2 reach + 1)^n steps in [-reach, reach]^n.
ivec4 steps_number(int i, int reach) {
    int side = 2 * reach + 1;
    return ivec4(i % side, i / side % side, i / (side * side) % side, i / (side * side * side)) -
           reach;
}
bool outermost(ivec4 steps, int reach) {
    return any(equal(abs(steps), ivec4(reach)));
}

NearestFeatures nearest_features(uint seed, uvec3 cell, vec3 place, uvec3 period) {
    NearestFeatures nearest = NearestFeatures(1e6, 1e6, vec4(0.0), vec4(0.0));
    visit_feature(seed, cell, place, period, ivec3(0), nearest);
    for (int i = 0; i < 27; ++i) {
        ivec3 steps = steps_number(i, 1).xyz;
        if (i != 13) visit_feature(seed, cell, place, period, steps, nearest);
    }
    for (int i = nearest.square2 <= 1.0 ? 125 : 0; i < 125;
         ++i) {  // cells two away have a distance of 1 or more
        ivec3 steps = steps_number(i, 2).xyz;
        if (outermost(ivec4(steps, 0), 2)) visit_feature(seed, cell, place, period, steps, nearest);
    }
    return nearest;
}

NearestFeatures nearest_features(uint seed, uvec4 cell, vec4 place, uvec4 period) {
    NearestFeatures nearest = NearestFeatures(1e6, 1e6, vec4(0.0), vec4(0.0));
    visit_feature(seed, cell, place, period, ivec4(0), nearest);
    for (int i = 0; i < 81; ++i) {
        ivec4 steps = steps_number(i, 1);
        if (i != 40) visit_feature(seed, cell, place, period, steps, nearest);
    }
    for (int i = nearest.square2 <= 1.0 ? 625 : 0; i < 625; ++i) {
        ivec4 steps = steps_number(i, 2);
        if (outermost(steps, 2)) visit_feature(seed, cell, place, period, steps, nearest);
    }
    return nearest;
}

float worley_f1(NearestFeatures nearest) {
    return nearest_root(nearest.square1);
}
float worley_f2(NearestFeatures nearest) {
    return nearest_root(nearest.square2);
}
float worley_f2_f1(NearestFeatures nearest) {
    exact float difference = nearest_root(nearest.square2) - nearest_root(nearest.square1);
    return difference;
}
