#pragma once
// Blender's Voronoi texture in three dimensions: distances to points, one in every unit cube
// (Worley, "A Cellular Texture Basis Function", 1996), a smooth minimum of them and the distance to
// the border between two (Quilez, "Voronoi borders", 2012, and "Smooth Voronoi", 2014).
#include "procedural/blender/hash.h"

namespace burl::blender {

enum class VoronoiFeature { f1, f2, smooth_f1, edge, radius };
enum class VoronoiMetric { euclidean, manhattan, chebychev, minkowski };

template <class T>
struct VoronoiShape {
    VoronoiFeature feature = VoronoiFeature::f1;
    VoronoiMetric metric = VoronoiMetric::euclidean;
    T smoothness, exponent, randomness;
};

/// The distance of a point, a colour of the cell of the point that counts, and that point.
template <class T>
struct VoronoiSample {
    T distance = T(0.0);
    Triple<T> color, position;
};

template <class T>
T voronoi_length(const VoronoiShape<T>& shape, const Triple<T>& way) {
    const T x = absolute(way.x), y = absolute(way.y), z = absolute(way.z);
    switch (shape.metric) {
        case VoronoiMetric::euclidean:
            return length(way);
        case VoronoiMetric::manhattan:
            return x + y + z;
        case VoronoiMetric::chebychev:
            return larger(x, larger(y, z));
        case VoronoiMetric::minkowski:
            break;
    }
    const T& e = shape.exponent;
    return raised(raised(x, e) + raised(y, e) + raised(z, e), quotient(T(1.0), e));
}

/// Calls visit(cell) for the cubes up to `reach` from a cube.
template <class Visit>
void for_cubes(const Triple<double>& middle, int reach, const Visit& visit) {
    for (int k = -reach; k <= reach; ++k)
        for (int j = -reach; j <= reach; ++j)
            for (int i = -reach; i <= reach; ++i)
                visit(middle + Triple<double>{double(i), double(j), double(k)});
}

/// The point of a cube, from `origin`.
template <class T>
Triple<T> voronoi_point(const VoronoiShape<T>& shape, const Triple<double>& cell,
                        const Triple<double>& origin) {
    return constants<T>(cell - origin) + times(shape.randomness, constants<T>(random_triple(cell)));
}

/// The nearest point, and the second nearest.
template <class T>
std::array<VoronoiSample<T>, 2> two_nearest(const Triple<T>& p, const VoronoiShape<T>& shape,
                                            const Triple<double>& origin) {
    std::array<VoronoiSample<T>, 2> near;
    near[0].distance = near[1].distance = T(1e30);
    std::array<Triple<double>, 2> cells{};
    for_cubes(floors(values_of(p)), 1, [&](const Triple<double>& cell) {
        const Triple<T> point = voronoi_point(shape, cell, origin);
        const T far = voronoi_length(shape, point - (p - constants<T>(origin)));
        if (!(value_of(far) < value_of(near[1].distance))) return;
        const bool first = value_of(far) < value_of(near[0].distance);
        if (first) near[1] = near[0], cells[1] = cells[0];
        near[first ? 0 : 1] = {far, {}, point + constants<T>(origin)};
        cells[first ? 0 : 1] = cell;
    });
    for (std::size_t i = 0; i < 2; ++i) near[i].color = constants<T>(random_triple(cells[i]));
    return near;
}

/// A minimum of distances, colours and points in which those count that differ by less than the
/// smoothness.
template <class T>
VoronoiSample<T> smooth_nearest(const Triple<T>& p, const VoronoiShape<T>& shape,
                                const Triple<double>& origin) {
    const T soft = clamped(T(0.5) * shape.smoothness, 0.0, 0.5);
    if (value_of(soft) == 0.0) return two_nearest(p, shape, origin)[0];
    VoronoiSample<T> sum;
    sum.distance = T(8.0);
    for_cubes(origin, 2, [&](const Triple<double>& cell) {
        const Triple<T> point = voronoi_point(shape, cell, origin);
        const T far = voronoi_length(shape, point - (p - constants<T>(origin)));
        const T h = smooth(clamped(T(0.5) + quotient(T(0.5) * (sum.distance - far), soft)));
        T less = soft * h * (T(1.0) - h);
        sum.distance = blended(h, sum.distance, far) - less;
        less = quotient(less, T(1.0) + T(3.0) * soft);
        const Triple<T> all{less, less, less};
        sum.color = blended(h, sum.color, constants<T>(random_triple(cell))) - all;
        sum.position = blended(h, sum.position, point) - all;
    });
    sum.position = sum.position + constants<T>(origin);
    return sum;
}

/// The distance to the nearest plane half way between the nearest point and another one.
template <class T>
T voronoi_edge(const Triple<T>& p, const VoronoiShape<T>& shape, const Triple<double>& origin) {
    const Triple<T> here = p - constants<T>(origin);
    Triple<T> nearest;
    double least = 1e30;
    for_cubes(origin, 1, [&](const Triple<double>& cell) {
        const Triple<T> way = voronoi_point(shape, cell, origin) - here;
        const double square = value_of(dot(way, way));
        if (square < least) least = square, nearest = way;
    });
    T edge = T(1e30);
    for_cubes(origin, 1, [&](const Triple<double>& cell) {
        const Triple<T> way = voronoi_point(shape, cell, origin) - here, across = way - nearest;
        if (!(value_of(dot(across, across)) > 1e-4)) return;
        const T half = T(0.5) * dot(nearest + way, across);
        edge = smaller(edge, quotient(half, length(across)));
    });
    return edge;
}

/// Half the distance from the point nearest to p to the one that is nearest to it.
template <class T>
T voronoi_radius(const Triple<T>& p, const VoronoiShape<T>& shape, const Triple<double>& origin) {
    const Triple<T> here = p - constants<T>(origin);
    Triple<T> nearest;
    Triple<double> home = origin;
    double least = 1e30;
    for_cubes(origin, 1, [&](const Triple<double>& cell) {
        const Triple<T> point = voronoi_point(shape, cell, origin);
        const double far = value_of(length(point - here));
        if (far < least) least = far, nearest = point, home = cell;
    });
    T closest = T(1e30);
    for_cubes(home, 1, [&](const Triple<double>& cell) {
        const bool same = cell.x == home.x && cell.y == home.y && cell.z == home.z;
        if (same) return;
        closest = smaller(closest, length(voronoi_point(shape, cell, origin) - nearest));
    });
    return T(0.5) * closest;
}

/// Blender's Voronoi texture at p.
template <class T>
VoronoiSample<T> voronoi(const Triple<T>& p, VoronoiShape<T> shape) {
    shape.randomness = clamped(shape.randomness);
    const Triple<double> origin = floors(values_of(p));
    switch (shape.feature) {
        case VoronoiFeature::f1:
            return two_nearest(p, shape, origin)[0];
        case VoronoiFeature::f2:
            return two_nearest(p, shape, origin)[1];
        case VoronoiFeature::smooth_f1:
            return smooth_nearest(p, shape, origin);
        case VoronoiFeature::edge:
            return {voronoi_edge(p, shape, origin), {}, {}};
        case VoronoiFeature::radius:
            break;
    }
    return {voronoi_radius(p, shape, origin), {}, {}};
}

}  // namespace burl::blender
