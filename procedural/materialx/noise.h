#pragma once
// MaterialX's noises at two or three dimensions: Perlin's (noise/hashed_perlin.h) and its sums of
// octaves, random numbers of cells, and distances to points, one in every cell (Worley, "A Cellular
// Texture Basis Function", 1996). MaterialX computes in float32; differences are the largest that
// tests/peers/materialx_points.py saw at 10,000 points of [-4, 4]^3, and the table of its values
// (tests/procedural/materialx) holds them.
#include "procedural/noise/hashed_perlin.h"

namespace burl::materialx {

using namespace numeric;

/// N noises; they differ by at most 3e-6 from MaterialX's.
template <std::size_t N, class T>
std::array<T, N> noises(int dimensions, const Triple<T>& p) {
    return dimensions == 2 ? hashed_noises_2d<N>(p) : hashed_noises<N>(p);
}

/// The octaves of a sum: how many, and the ratios of their frequencies and weights.
template <class T>
struct Octaves {
    T count, lacunarity, diminish;
};

/// The largest number of octaves of a sum.
inline constexpr double most_octaves = 100.0;

/// The sums of octaves of frequencies 1, l, l^2, ... and weights 1, d, d^2, ...; three octaves
/// differ by at most 3e-6 from MaterialX's, six, which lie 60 times as far from 0, by 4e-5.
template <std::size_t N, class T>
std::array<T, N> fractals(int dimensions, Triple<T> p, const Octaves<T>& octaves) {
    std::array<T, N> sums{};
    T weight = T(1.0);
    const int count = int(value_of(clamped(octaves.count, 0.0, most_octaves)));
    for (int k = 0; k < count; ++k) {
        const std::array<T, N> octave = noises<N>(dimensions, p);
        for (std::size_t n = 0; n < N; ++n) sums[n] = sums[n] + weight * octave[n];
        weight = weight * octaves.diminish;
        p = times(octaves.lacunarity, p);
    }
    return sums;
}

/// Random numbers in [0, 1] of the cell that holds a point: one of its coordinates' hash, several
/// of these and their own number. All 0 beyond 2^30 cells. They differ by at most 5e-8 from
/// MaterialX's.
template <std::size_t N, class T>
std::array<T, N> cell_noises(int dimensions, const Triple<double>& p) {
    const Triple<double> cell = floors({p.x, p.y, dimensions == 2 ? 0.0 : p.z});
    std::array<T, N> all{};
    if (!has_words(cell)) return all;
    const std::uint32_t x = low_word(cell.x), y = low_word(cell.y), z = low_word(cell.z);
    for (std::uint32_t n = 0; n < N; ++n) {
        std::uint32_t hash;
        if (N == 1)
            hash = dimensions == 2 ? hash_words({x, y}) : hash_words({x, y, z});
        else
            hash = dimensions == 2 ? hash_words({x, y, n}) : hash_words({x, y, z, n});
        all[n] = T(double(hash) / 4294967295.0);
    }
    return all;
}

/// The results of Worley's noise: distances to the nearest points, or random numbers of the nearest
/// point's cell.
enum class WorleyStyle { distance, solid };

/// The way from p to the point of a cell, `steps` from p's.
template <class T>
Triple<T> way_to_point(int dimensions, const Triple<T>& p, const Triple<double>& steps,
                       const T& jitter) {
    const Triple<double> home = floors(values_of(p)), cell = home + steps;
    const std::array<double, 3> random = cell_noises<3, double>(dimensions, cell);
    const auto along = [&](double step, double number, const T& x, double origin) {
        return T(step + 0.5) + jitter * T(number - 0.5) - (x - T(origin));
    };
    return {along(steps.x, random[0], p.x, home.x), along(steps.y, random[1], p.y, home.y),
            dimensions == 2 ? T(0.0) : along(steps.z, random[2], p.z, home.z)};
}

/// Distances to the N nearest points of p's cell and of those around it, or N random numbers of the
/// nearest one's cell; they differ by at most 2e-7 from MaterialX's.
template <std::size_t N, class T>
std::array<T, N> worley(int dimensions, const Triple<T>& p, const T& jitter, WorleyStyle style) {
    std::array<T, N> squares;
    squares.fill(T(1e6));
    Triple<double> nearest = floors(values_of(p));
    const int deep = dimensions == 2 ? 0 : 1;
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j)
            for (int k = -deep; k <= deep; ++k) {
                const Triple<double> steps{double(i), double(j), double(k)};
                const Triple<T> way = way_to_point(dimensions, p, steps, jitter);
                T square = dot(way, way);
                if (value_of(square) < value_of(squares[0])) nearest = floors(values_of(p)) + steps;
                for (T& known : squares)
                    if (value_of(square) < value_of(known)) std::swap(square, known);
            }
    if (style == WorleyStyle::solid) return cell_noises<N, T>(dimensions, nearest);
    for (T& square : squares) square = root(square);
    return squares;
}

}  // namespace burl::materialx
