#pragma once
// The map of a disk-shaped patch into the plane with a free outline, as near to an isometry as the
// patch allows. It starts from the harmonic map onto a circle, which is one to one (Tutte 1963,
// Floater 1997), and descends on the symmetric Dirichlet energy (Schreiner, Asirvatham, Praun &
// Hoppe, "Inter-surface mapping", 2004), which is infinite where a triangle collapses, by L-BFGS
// with the Laplacian as its first guess of the Hessian (Kovalsky, Galun & Lipman, "Accelerated
// quadratic proxy for geometric optimization", 2016).
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "atlas/chart/patch.h"

namespace burl {

/// A map of a patch into the plane.
struct FreeMap {
    std::vector<Vec2d> places;  ///< place of each vertex, in units of the patch's points
    /// Mean over the area of (s1^2 + s2^2 + 1/s1^2 + 1/s2^2) / 4 for the singular values s1 and s2
    /// of each triangle's map; 1 for an isometry.
    double energy = std::numeric_limits<double>::infinity();
    int iterations = 0;  ///< iterations of the descent
};

/// Effort of free maps.
struct FreeMapOptions {
    int iterations = 60;
    /// Gain of an iteration relative to the energy beyond 1, below which the descent stops.
    double least_gain = 1e-3;
    /// Energy that is wanted: the descent is given up where it will not get there.
    double wanted = std::numeric_limits<double>::infinity();
};

/// The map of a disk; nothing where no start without a flip is found.
std::optional<FreeMap> map_freely(const Patch& patch, const FreeMapOptions& options = {});

/// Whether the outline of a map crosses itself, so that some places show two points. Linear in the
/// outline's edges where they are of about the same length.
bool overlaps_itself(const Patch& patch, std::span<const Vec2d> places);

/// The symmetric Dirichlet energy of maps of one patch. Triangles that close holes weigh
/// `fan_weight`; slivers are kept from flipping, but hardly weigh.
class IsometryEnergy {
  public:
    /// Lays the patch's triangles flat; the patch need not outlive the object.
    explicit IsometryEnergy(const Patch& patch);

    /// The energy of the map that puts the vertices at `places`, infinite where a triangle is
    /// flipped, and its gradient at each vertex, which means nothing where the energy is infinite.
    double operator()(std::span<const Vec2d> places, std::span<Vec2d> gradient) const;
    /// The largest t for which no triangle of places + t direction has collapsed yet.
    double step_to_collapse(std::span<const Vec2d> places, std::span<const Vec2d> direction) const;

  private:
    /// A triangle laid flat: corner 0 at the origin, corner 1 at (x1, 0), corner 2 at (x2, y2).
    struct Flat {
        Triangle vertices;
        double x1, x2, y2;
        double weight;  ///< share of the patch's area
    };
    std::vector<Flat> triangles_;
};

}  // namespace burl
