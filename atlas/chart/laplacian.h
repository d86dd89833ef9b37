#pragma once
// Harmonic coordinates on a patch: the cotangent Laplacian (Pinkall & Polthier, "Computing discrete
// minimal surfaces and their conjugates", 1993) with its weights kept positive, because only then
// is the map of a disk onto a convex shape one to one (Floater 1997). It is factored once by sparse
// Cholesky for a set of free vertices, then solved for as many borders as wanted; the same factor
// is the preconditioner of the descent on the map's stretch.
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "atlas/chart/patch.h"

namespace burl {

/// Weights of a patch's edges: clamped cotangents, or all 1.
enum class EdgeWeights { cotangent, uniform };

/// Bounds of cotangent weights; weights are pure numbers, so nothing depends on the mesh's scale.
inline constexpr double least_edge_weight = 0.001, most_edge_weight = 100.0;

/// A patch's edges with their weights, and an order of its vertices in which eliminating them
/// causes little fill-in (approximate minimum degree): the common part of all Laplacians of the
/// patch.
struct WeightedEdges {
    struct Edge {
        std::uint32_t a = 0, b = 0;
        double weight = 0.0;
        /// The triangles on both sides of the edge, the same one twice on the border.
        std::array<std::uint32_t, 2> triangles{};
    };
    std::vector<Edge> edges;
    std::vector<std::uint32_t> order;
};

/// The edges of a patch with their weights.
std::vector<WeightedEdges::Edge> edges_with_weights(const Patch& patch, EdgeWeights weights);

/// The weighted edges of a patch. `order` is an elimination order of its vertices that is known
/// already; empty: it is computed.
WeightedEdges weighted_edges(const Patch& patch, EdgeWeights weights = EdgeWeights::cotangent,
                             std::vector<std::uint32_t> order = {});

/// The factored Laplacian of a patch for a set of free vertices.
class PatchLaplacian {
  public:
    /// `is_free` has one entry per vertex. Every connected set of free vertices must touch a vertex
    /// that is not free, else factoring fails.
    PatchLaplacian(const WeightedEdges& edges, const std::vector<bool>& is_free);
    ~PatchLaplacian();
    PatchLaplacian(PatchLaplacian&&) noexcept;
    PatchLaplacian& operator=(PatchLaplacian&&) noexcept;

    /// Whether the last factoring succeeded.
    bool factored() const;

    /// Factors again for other weights of the same edges.
    void refactor(const WeightedEdges& edges);

    /// Sets the free vertices' values to the harmonic ones for the other vertices' values, in each
    /// of the fields (one value per vertex); solving for several fields at once is cheaper than one
    /// after the other, with the same bits.
    void solve_harmonic(std::span<std::vector<Vec2d>> fields) const;

    /// Applies the inverse of the free vertices' matrix to `values`; the result is 0 at the other
    /// vertices. One entry per vertex. `result` may be `values`.
    void apply_inverse(std::span<const double> values, std::span<double> result) const;
    /// Applies the inverse to both coordinates of `values` in place, with the same bits.
    void apply_inverse(std::span<Vec2d> values) const;

  private:
    struct Factor;
    std::unique_ptr<Factor> factor_;
};

}  // namespace burl
