#pragma once
// Harmonic coordinates on a patch: the cotangent Laplacian (Pinkall & Polthier, "Computing discrete
// minimal surfaces and their conjugates", 1993) with its weights kept positive, because only then
// is the map of a disk onto a convex shape one to one (Floater 1997). Factored once by sparse
// Cholesky for a set of free vertices, then solved for as many borders as wanted; the same factor
// is the preconditioner of the descent on the map's stretch.
#include <memory>
#include <span>
#include <vector>

#include "atlas/patch.h"

namespace burl {

enum class EdgeWeights { cotangent, uniform };

/// Bounds for cotangent weights; they are pure numbers, so nothing depends on the mesh's scale.
inline constexpr double least_edge_weight = 0.001, most_edge_weight = 100.0;

class PatchLaplacian {
  public:
    /// `is_free` has one entry per vertex. The sum of its connected free parts must each touch a
    /// vertex that is not free, else factoring fails.
    PatchLaplacian(const Patch& patch, const std::vector<bool>& is_free,
                   EdgeWeights weights = EdgeWeights::cotangent);
    ~PatchLaplacian();
    PatchLaplacian(PatchLaplacian&&) noexcept;
    PatchLaplacian& operator=(PatchLaplacian&&) noexcept;

    bool factored() const;

    /// Sets the free vertices' values to the harmonic ones for the others' values.
    void solve_harmonic(std::span<Vec2d> values) const;

    /// The inverse of the free vertices' matrix applied to `values`; 0 at the others. One entry per
    /// vertex. `result` may be `values`.
    void apply_inverse(std::span<const double> values, std::span<double> result) const;

  private:
    struct Factor;
    std::unique_ptr<Factor> factor_;
};

}  // namespace burl
