// Random numbers of lattice cells, cells round feature points, and shapes strewn over the plane, as
// in procedural/noise/cell_features.h and procedural/graph/scattered_shapes.cpp. What has a gradient
// is a real4 of the value and its derivatives along the coordinates. This part must follow
// noise/lattice.glsl, numbers/elementary.glsl and graph/graph.glsl.

// 24 bits as a number in [0, 1).
real unit_number(uint bits) {
    return real(bits) * real(5.9604644775390625e-8);  // 2^-24
}

// Number n of the random numbers in [0, 1) that belong to a hash.
real hash_number(uint hash, uint n) {
    return unit_number(mix_bits(hash + n * prime_seed) >> 8);
}

// The random number in [0, 1) of the unit cell that holds p.
real cell_number(real3 p, uint seed) {
    return unit_number(lattice_bits(cell_bits(lattice_site(p, uvec3(0u))), seed) >> 8);
}

// ---- Cells ----

// Feature points about a site, and the nearest of them: the way from it, and the steps to its cube.
struct CellSearch {
    uvec3 cell;
    real3 place;
    uint seed;
    real jitter, square;
    ivec3 steps;
    real3 way;
};

// The i-th of the (2 reach + 1)^3 steps in [-reach, reach]^3.
ivec3 cell_steps(int i, int reach) {
    int side = 2 * reach + 1;
    return ivec3(i % side, i / side % side, i / (side * side)) - reach;
}
int cells_within(int reach) {
    int side = 2 * reach + 1;
    return side * side * side;
}
// Whether the largest step is `reach`.
bool on_ring(ivec3 steps, int reach) {
    return any(equal(abs(steps), ivec3(reach)));
}
// A bound below the distance of cubes on a ring.
real ring_distance(int reach) {
    return real(max(reach - 1, 0));
}

// The squared distance along an axis of a place to the cube that lies `steps` away.
real step_square(real place, int steps) {
    exact real gap = abs(real(steps) - place) - real(0.5), square = gap * gap;
    return steps == 0 ? real(0.0) : square;
}
real square_to_cell(real3 place, ivec3 steps) {
    exact real square = step_square(place.x, steps.x) + step_square(place.y, steps.y) +
                        step_square(place.z, steps.z);
    return square;
}

real square_of(real3 way) {
    exact real square = way.x * way.x + way.y * way.y + way.z * way.z;
    return square;
}

// The way to the site from the feature point of the cube that lies `steps` away.
real3 way_from(CellSearch search, ivec3 steps) {
    uint h = lattice_bits(search.cell + uvec3(steps), search.seed);
    real3 number = real3(hash_number(h, 0u), hash_number(h, 1u), hash_number(h, 2u));
    exact real3 feature = search.jitter * (number - real(0.5)) + real3(steps);
    exact real3 way = search.place - feature;
    return way;
}

CellSearch nearest_cell(real3 p, uint seed, real jitter) {
    LatticeSite site = lattice_site(p, uvec3(0u));
    CellSearch search =
        CellSearch(cell_bits(site), site.place, seed, jitter, real(1e6), ivec3(0), real3(0.0));
    for (int reach = 0; reach <= 2; ++reach) {
        if (ring_distance(reach) * ring_distance(reach) >= search.square) break;
        for (int i = 0; i < cells_within(reach); ++i) {
            ivec3 steps = cell_steps(i, reach);
            if (!on_ring(steps, reach) || square_to_cell(search.place, steps) >= search.square)
                continue;
            real3 way = way_from(search, steps);
            real square = square_of(way);
            if (square >= search.square) continue;
            search.square = square;
            search.steps = steps;
            search.way = way;
        }
    }
    return search;
}

// The distance to the nearest bisector plane, with its gradient.
real4 cell_edge(CellSearch search) {
    real near = nearest_root(search.square);
    real4 nearest = real4(2.0, real3(0.0));
    for (int reach = 0; reach <= 4; ++reach) {
        exact real farthest = near + real(2.0) * nearest.x;
        if (ring_distance(reach) >= farthest) break;
        for (int i = 0; i < cells_within(reach); ++i) {
            ivec3 steps = cell_steps(i, reach);
            if (!on_ring(steps, reach) || steps == search.steps) continue;
            exact real limit = near + real(2.0) * nearest.x, square = limit * limit;
            if (square_to_cell(search.place, steps) >= square) continue;
            real3 way = way_from(search, steps);
            exact real3 across = way - search.way, twice = way + search.way;
            real apart = nearest_root(square_of(across));
            exact real away =
                (across.x * twice.x + across.y * twice.y + across.z * twice.z) / (real(2.0) * apart);
            exact real3 slope = across / apart;
            if (away < nearest.x) nearest = real4(max(away, real(0.0)), slope);
        }
    }
    return nearest;
}

// The distance to the nearest feature point (gives 0), that to its cell's border (1), or a random
// number of the cell (2).
real4 cell_feature(real3 p, uint seed, real jitter, int gives) {
    CellSearch search = nearest_cell(p, seed, jitter);
    if (gives == 1) return cell_edge(search);
    if (gives == 2)
        return real4(hash_number(lattice_bits(search.cell + uvec3(search.steps), seed), 3u),
                     real3(0.0));
    real away = nearest_root(search.square);
    exact real3 slope = search.way / away;
    return real4(away, search.square > real(0.0) ? slope : real3(0.0));
}

// ---- Shapes of radius 1: the distance to the border, positive inside, and its gradient ----

// The distance `size` less that of the place, (x, y) from a point; `sign` are the place's mirrors.
real3 shape_round(real x, real y, real size, real2 sign) {
    real away = length_of(x, y);
    exact real distance_of = size - away;
    exact real2 slope = -(sign * (real2(x, y) / away));
    return real3(distance_of, away > real(0.0) ? slope : real2(0.0));
}

real3 shape_disk(real2 p) {
    return shape_round(p.x, p.y, real(1.0), real2(1.0));
}

real3 shape_ring(real2 p) {
    real3 round_of = shape_disk(p);
    exact real inner = real(0.5) - round_of.x;
    return round_of.x < real(0.25) ? round_of : real3(inner, -round_of.yz);
}

real2 signs_of(real2 p) {
    return real2(p.x < real(0.0) ? real(-1.0) : real(1.0), p.y < real(0.0) ? real(-1.0) : real(1.0));
}

#if REAL_IS_DOUBLE
const double half_side = 0.7071067811865476lf, sine36 = 0.5877852522924731lf,
             cosine36 = 0.8090169943749475lf, notch_x = 0.22451398828979269lf,
             notch_y = -0.6909830056250525lf;
#else
const float half_side = 0.7071067811865476, sine36 = 0.5877852522924731,
            cosine36 = 0.8090169943749475, notch_x = 0.22451398828979269,
            notch_y = -0.6909830056250525;
#endif

real3 shape_square(real2 p) {
    real2 sign = signs_of(p);
    exact real2 beyond = abs(p) - half_side;
    if (beyond.x > real(0.0) && beyond.y > real(0.0))
        return shape_round(beyond.x, beyond.y, real(0.0), sign);
    return beyond.x > beyond.y ? real3(-beyond.x, -sign.x, real(0.0))
                               : real3(-beyond.y, real(0.0), -sign.y);
}

// The mirror image in the line through the origin, 36 degrees from the y axis.
real2 star_mirror(real2 p) {
    exact real twice = real(2.0) * (p.x * cosine36 - p.y * sine36);
    exact real2 image = real2(p.x - twice * cosine36, p.y + twice * sine36);
    return image;
}

// The distance to the segment from the tip (0, 1) to a notch, positive on the origin's side.
real3 star_side(real2 p) {
    exact real square = notch_x * notch_x + notch_y * notch_y;
    exact real ahead = p.y - real(1.0);
    exact real t = (p.x * notch_x + ahead * notch_y) / square;
    t = min(max(t, real(0.0)), real(1.0));
    exact real2 way = real2(p.x - t * notch_x, ahead - t * notch_y);
    exact real side = notch_x * ahead - notch_y * p.x;
    real sign = side < real(0.0) ? real(1.0) : real(-1.0);
    real away = length_of(way.x, way.y);
    exact real2 slope = sign * (way / away);
    return away > real(0.0) ? real3(sign * away, slope) : real3(0.0);
}

real3 shape_star(real2 p) {
    bool left0 = p.x < real(0.0);
    p.x = abs(p.x);
    real2 image = star_mirror(p);
    bool folded0 = image.x < p.x;
    if (folded0) p = image;
    bool left1 = p.x < real(0.0);
    p.x = abs(p.x);
    image = star_mirror(p);
    bool folded1 = image.x < p.x;
    if (folded1) p = image;
    bool left2 = p.x < real(0.0);
    p.x = abs(p.x);
    real3 result = star_side(p);
    if (left2) result.y = -result.y;
    if (folded1) result.yz = star_mirror(result.yz);
    if (left1) result.y = -result.y;
    if (folded0) result.yz = star_mirror(result.yz);
    if (left0) result.y = -result.y;
    return result;
}

real3 shape_leaf(real2 p) {
    real2 sign = signs_of(p), size = abs(p);
    exact real ahead = size.y - real(1.0), aside = size.x + real(0.75);
    exact real beyond = ahead * real(0.75);
    if (beyond > size.x) return shape_round(size.x, ahead, real(0.0), sign);
    return shape_round(aside, size.y, real(1.25), sign);
}

real3 shape_distance(int form, real2 p) {
    if (form == 0) return shape_disk(p);
    if (form == 1) return shape_square(p);
    if (form == 2) return shape_ring(p);
    return form == 3 ? shape_star(p) : shape_leaf(p);
}

// ---- Scattered shapes ----

struct ScatteredShapes {
    uint seed;
    int form;
    real radius, spread, turn, jitter, chance;
    int gives;
    real outside;  // the largest distance from outside that is told
};

// The distance to the border of the shape whose square has this hash, at a place from its middle.
real3 shape_at(ScatteredShapes shapes, uint hash, real2 place) {
    real2 number = real2(hash_number(hash, 1u), hash_number(hash, 2u));
    exact real2 middle = shapes.jitter * (number - real(0.5));
    exact real2 way = place - middle;
    exact real radius = shapes.radius + shapes.spread * hash_number(hash, 3u);
    exact real turn = shapes.turn * hash_number(hash, 4u);
    real c = cosine(turn), s = sine(turn);
    exact real2 turned = real2(c * way.x + s * way.y, c * way.y - s * way.x) / radius;
    real3 own = shape_distance(shapes.form, turned);
    exact real3 result = real3(radius * own.x, c * own.y - s * own.z, s * own.y + c * own.z);
    return result;
}

// The distance to the border that is largest (gives 0), that of the top shape (1), or a random
// number of the top shape (2).
real4 scattered_at(ScatteredShapes shapes, real x, real y) {
    LatticeSite site = lattice_site(real3(x, y, real(0.0)), uvec3(0u));
    uvec3 cell = cell_bits(site);
    real3 cover = real3(-1.0, 0.0, 0.0), top = cover;
    real id = real(-1.0), outer_id = real(0.0);
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            uint hash = lattice_bits(uvec3(cell.x + uint(i), cell.y + uint(j), 0u), shapes.seed);
            if (hash_number(hash, 5u) >= shapes.chance) continue;
            exact real2 place = site.place.xy - real2(real(i), real(j));
            real3 own = shape_at(shapes, hash, place);
            real number = hash_number(hash, 0u);
            if (own.x >= real(0.0) && number > id) {
                top = own;
                id = number;
            }
            if (own.x > cover.x) {
                cover = own;
                outer_id = number;
            }
        }
    if (shapes.gives == 0) return real4(cover, real(0.0));
    if (shapes.gives == 2) return real4(id >= real(0.0) ? id : outer_id, real3(0.0));
    if (id >= real(0.0)) return real4(top, real(0.0));
    return cover.x > -shapes.outside ? real4(cover, real(0.0)) : real4(-shapes.outside, real3(0.0));
}
