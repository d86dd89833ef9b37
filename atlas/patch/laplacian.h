#pragma once
// Harmonic coordinates on a patch: the cotangent Laplacian (Pinkall & Polthier, "Computing discrete
// minimal surfaces and their conjugates", 1993) with its weights kept positive, because only then
// is the map of a disk onto a convex shape one to one (Floater 1997). Factored once by sparse
// Cholesky for a set of free vertices, then solved for as many borders as wanted; the same factor
// is the preconditioner of the descent on the map's stretch.
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "atlas/patch/patch.h"

namespace burl {

enum class EdgeWeights { cotangent, uniform };

/// Bounds for cotangent weights; they are pure numbers, so nothing depends on the mesh's scale.
inline constexpr double least_edge_weight = 0.001, most_edge_weight = 100.0;

/// A patch's edges with their weights, and an order of its vertices in which eliminating them fills
/// little (approximate minimum degree): what all Laplacians of the patch share.
struct WeightedEdges {
    struct Edge {
        std::uint32_t a = 0, b = 0;
        double weight = 0.0;
        /// The triangles it is a side of, the same one twice on the border.
        std::array<std::uint32_t, 2> triangles{};
    };
    std::vector<Edge> edges;
    std::vector<std::uint32_t> order;
};

/// `order`: one that is known already, of a patch with at most some more inner vertices.
WeightedEdges weighted_edges(const Patch& patch, EdgeWeights weights = EdgeWeights::cotangent,
                             std::vector<std::uint32_t> order = {});

class PatchLaplacian {
  public:
    /// `is_free` has one entry per vertex. The sum of its connected free parts must each touch a
    /// vertex that is not free, else factoring fails.
    PatchLaplacian(const WeightedEdges& edges, const std::vector<bool>& is_free);
    ~PatchLaplacian();
    PatchLaplacian(PatchLaplacian&&) noexcept;
    PatchLaplacian& operator=(PatchLaplacian&&) noexcept;

    bool factored() const;

    /// Factors again for other weights of the same edges.
    void refactor(const WeightedEdges& edges);

    /// Sets the free vertices' values to the harmonic ones for the others' values, in each of the
    /// fields; solving for several at once is cheaper than one after the other, with the same bits.
    void solve_harmonic(std::span<std::vector<Vec2d>> fields) const;

    /// The inverse of the free vertices' matrix applied to `values`; 0 at the others. One entry per
    /// vertex. `result` may be `values`.
    void apply_inverse(std::span<const double> values, std::span<double> result) const;

  private:
    struct Factor;
    std::unique_ptr<Factor> factor_;
};

}  // namespace burl
