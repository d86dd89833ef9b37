#pragma once
// Cells around feature points, one of which lies in every unit cube: Worley's ("A Cellular Texture
// Basis Function", 1996), each the part of space that is nearest to its point. The distance to a
// cell's border is that to the nearest bisector plane between its point p and another point q,
// (|x - q|^2 - |x - p|^2) / (2 |q - p|), and so at least half of |x - q| - |x - p|. Hence no q
// counts that is farther away than |x - p| + 2 d, where d is the smallest distance so far.
#include "procedural/noise/worley_noise.h"

namespace burl {

/// The number that the cell around a point gives.
enum class CellGives {
    distance,  ///< distance to the cell's feature point
    edge,      ///< distance to the cell's border
    id,        ///< a random number in [0, 1) of the cell
};

/// Feature points, each in the middle of its unit cube, or moved from there by up to half of
/// `jitter`, 0 to 1, along each axis.
struct CellPoints {
    std::uint32_t seed = 0;
    double jitter = 1.0;
    bool operator==(const CellPoints&) const = default;
};

/// Number n of the random numbers in [0, 1), in steps of 2^-24, that belong to a hash.
inline double hash_number(std::uint32_t hash, std::uint32_t n) {
    return 0x1p-24 * double(LatticeHash::mix(hash + n * LatticeHash::prime_seed) >> 8);
}

/// The random number in [0, 1), in steps of 2^-24, of the unit cell that holds a point.
inline double cell_number(const Point<3>& p, std::uint32_t seed) {
    const auto site = lattice_site<double, 3>(p);
    return 0x1p-24 *
           double(LatticeHash::bits(site.index(0, 0), site.index(1, 0), site.index(2, 0), seed) >>
                  8);
}

/// A search among the feature points about a site.
class CellSearch {
  public:
    using Steps = std::array<int, 3>;
    using Way = std::array<double, 3>;

    CellSearch(const LatticeSite<double, 3>& site, const CellPoints& points)
        : site_(site), points_(points) {
        // Some point is within sqrt(3), and unit cubes three away are at least 2 away.
        for (int reach = 0; reach <= 2 && ring(reach) * ring(reach) < square_; ++reach)
            visit(reach, [this](const Steps& steps) { keep_nearest(steps); });
    }

    /// The distance to the nearest feature point, 0 to sqrt(3), with its gradient.
    NoiseSample<double, 3> distance() const {
        NoiseSample<double, 3> result{std::sqrt(square_), {}};
        if (square_ > 0.0)
            for (std::size_t i = 0; i < 3; ++i) result.gradient[i] = way_[i] / result.value;
        return result;
    }

    /// The distance d to the nearest bisector plane, with its gradient, which has length 1. The
    /// ball of radius d about the site is in p's cell, and every point of it within sqrt(3) of a
    /// feature point, so |x - p| + d <= sqrt(3): what counts is within 2 sqrt(3), and unit cubes
    /// five away are at least 4 away.
    NoiseSample<double, 3> edge() const {
        const double near = std::sqrt(square_);
        NoiseSample<double, 3> result{2.0, {}};
        for (int reach = 0; reach <= 4 && ring(reach) < near + 2.0 * result.value; ++reach)
            visit(reach, [&](const Steps& steps) { keep_plane(steps, near, result); });
        return result;
    }

    /// The random number of the nearest feature point's unit cube, in [0, 1).
    double id() const { return hash_number(bits(steps_), 3); }

  private:
    /// A bound below the distance of unit cubes whose largest step is `reach`.
    static double ring(int reach) { return double(std::max(reach - 1, 0)); }

    template <class Visit>
    static void visit(int reach, const Visit& to) {
        Steps steps;
        steps.fill(-reach);
        do {
            if (std::ranges::any_of(steps, [=](int step) { return std::abs(step) == reach; }))
                to(steps);
        } while (next_steps(steps, reach));
    }

    std::uint32_t bits(const Steps& steps) const {
        return LatticeHash::bits(site_.index(0, steps[0]), site_.index(1, steps[1]),
                                 site_.index(2, steps[2]), points_.seed);
    }

    /// The way to the site from the feature point of the unit cube that lies `steps` away.
    Way way_from(const Steps& steps) const {
        const std::uint32_t h = bits(steps);
        Way way;
        for (std::uint32_t i = 0; i < 3; ++i)
            way[i] =
                site_.place[i] - (points_.jitter * (hash_number(h, i) - 0.5) + double(steps[i]));
        return way;
    }

    void keep_nearest(const Steps& steps) {
        if (square_to_cell(site_.place, steps) >= square_) return;
        const Way way = way_from(steps);
        const double square = way[0] * way[0] + way[1] * way[1] + way[2] * way[2];
        if (square < square_) square_ = square, steps_ = steps, way_ = way;
    }

    void keep_plane(const Steps& steps, double near, NoiseSample<double, 3>& nearest) const {
        const double reach = near + 2.0 * nearest.value;
        if (steps == steps_ || square_to_cell(site_.place, steps) >= reach * reach) return;
        const Way way = way_from(steps);
        Way across, twice;  // q to p; twice the way from their middle
        for (std::size_t i = 0; i < 3; ++i)
            across[i] = way[i] - way_[i], twice[i] = way[i] + way_[i];
        const double apart =
            std::sqrt(across[0] * across[0] + across[1] * across[1] + across[2] * across[2]);
        const double away =
            (across[0] * twice[0] + across[1] * twice[1] + across[2] * twice[2]) / (2.0 * apart);
        if (!(away < nearest.value)) return;
        nearest.value = std::max(away, 0.0);
        for (std::size_t i = 0; i < 3; ++i) nearest.gradient[i] = across[i] / apart;
    }

    const LatticeSite<double, 3>& site_;
    CellPoints points_;
    double square_ = 1e6;  ///< squared distance of the nearest feature point
    Steps steps_{};        ///< steps to its unit cube
    Way way_{};            ///< way from it to the site
};

/// The distance, edge or id of the cell around a point, in units of cells, with its gradient.
inline NoiseSample<double, 3> cell_feature(const Point<3>& p, const CellPoints& points,
                                           CellGives gives) {
    const auto site = lattice_site<double, 3>(p);
    const CellSearch search(site, points);
    if (gives == CellGives::distance) return search.distance();
    return gives == CellGives::edge ? search.edge() : NoiseSample<double, 3>{search.id(), {}};
}

}  // namespace burl
