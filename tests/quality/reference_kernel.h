#pragma once
// A computation that never changes, as a clock: a layout's time over its time is much the same on
// every machine. It does what layouts do (sorting, neighbours in a mesh of random order, sweeps of
// a sparse system, spans of texels), but calls nothing of Burl's, so that no change of Burl's
// changes it. Whoever changes it measures the table anew (quality.py --update).
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <vector>

namespace burl::test {

/// A generator of numbers that look random (SplitMix64, Steele et al. 2014).
class KernelNumbers {
  public:
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

  private:
    std::uint64_t state_ = 1;
};

/// The vertices of a square grid in random order, each with its four neighbours round a torus.
inline std::vector<std::uint32_t> shuffled_grid(std::uint32_t side) {
    KernelNumbers numbers;
    std::vector<std::uint32_t> place(std::size_t(side) * side);
    std::iota(place.begin(), place.end(), 0u);
    for (std::size_t i = place.size() - 1; i > 0; --i)
        std::swap(place[i], place[numbers.next() % (i + 1)]);
    std::vector<std::uint32_t> neighbours(4 * place.size());
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            const auto at = [&](std::uint32_t u, std::uint32_t v) {
                return place[std::size_t(v % side) * side + u % side];
            };
            std::uint32_t* four = &neighbours[4 * std::size_t(at(x, y))];
            four[0] = at(x + 1, y), four[1] = at(x + side - 1, y);
            four[2] = at(x, y + 1), four[3] = at(x, y + side - 1);
        }
    return neighbours;
}

/// Relaxes a value per vertex towards the mean of its neighbours, some times over.
inline double relaxed(const std::vector<std::uint32_t>& neighbours, int sweeps) {
    std::vector<double> values(neighbours.size() / 4);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::sin(double(i));
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::uint32_t* four = &neighbours[4 * i];
            values[i] =
                0.24 * (values[four[0]] + values[four[1]] + values[four[2]] + values[four[3]]) +
                0.04 * std::sqrt(1.0 + values[i] * values[i]);
        }
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Finds each edge's partner by a hash table, and sorts the edges.
inline double matched(const std::vector<std::uint32_t>& neighbours) {
    std::unordered_map<std::uint64_t, std::uint32_t> first;
    std::vector<std::uint64_t> edges;
    for (std::size_t i = 0; i < neighbours.size(); ++i) {
        const auto [low, high] = std::minmax(std::uint32_t(i / 4), neighbours[i]);
        const std::uint64_t key = (std::uint64_t(low) << 32) | high;
        if (!first.emplace(key, std::uint32_t(i)).second)
            edges.push_back(key * 0x9e3779b97f4a7c15u);
    }
    std::sort(edges.begin(), edges.end());
    return double(edges[edges.size() / 2] >> 40);
}

/// Fills triangles' spans of a square image, each row's ends by a division.
inline double filled(std::uint32_t side, int triangles) {
    KernelNumbers numbers;
    std::vector<float> image(std::size_t(side) * side);
    for (int t = 0; t < triangles; ++t) {
        const auto width = 8 + std::uint32_t(numbers.next() % 24), height = width / 2 + 3;
        const auto x = std::uint32_t(numbers.next() % (side - 32));
        const auto y = std::uint32_t(numbers.next() % (side - 32));
        for (std::uint32_t row = 0; row < height; ++row) {
            const double share = double(row) / double(height);
            const auto end = x + std::uint32_t(std::ceil(share * double(width)));
            for (std::uint32_t at = x; at < end; ++at)
                image[std::size_t(y + row) * side + at] += float(share) * float(at);
        }
    }
    return std::accumulate(image.begin(), image.end(), 0.0);
}

/// The kernel: some 12 ms of one core, in memory that the core keeps near: with larger grids its
/// time varies by a fifth while other programs run, a layout's by a twentieth. Its result is to be
/// used, lest a compiler leave it out.
inline double reference_kernel() {
    const std::vector<std::uint32_t> grid = shuffled_grid(64);
    double sum = relaxed(grid, 400) + filled(128, 12000);
    for (int run = 0; run < 6; ++run) sum += matched(grid);
    return sum;
}

}  // namespace burl::test
