// Matching of neighbouring triangles: greedy by a key (for strips likeness of weights and length of
// the common edge), then short alternating paths from the triangles left over (Berge's lemma,
// without blossoms).
#include "atlas/blocks/pairing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <tbb/parallel_sort.h>

#include "atlas/base/each_index.h"

namespace burl {

namespace {

using HalfEdge = std::int32_t;

class Matcher {
  public:
    Matcher(std::span<const HalfEdge> opposite, std::span<const std::uint32_t> keys)
        : opposite_(opposite),
          keys_(keys),
          mate_edge_(keys.size() / 3, -1),
          parent_(keys.size() / 3, -1),
          seen_(keys.size() / 3, 0) {}

    bool allowed(HalfEdge h) const { return keys_[std::size_t(h)] != never_pair; }
    bool single(std::int32_t t) const { return mate_edge_[std::size_t(t)] < 0; }
    void match(HalfEdge h) {
        const HalfEdge o = opposite_[std::size_t(h)];
        mate_edge_[std::size_t(h / 3)] = h;
        mate_edge_[std::size_t(o / 3)] = o;
    }
    void augment_from(std::int32_t root);
    std::vector<std::int8_t> edges() const;

  private:
    std::int32_t mate(std::int32_t t) const {
        return opposite_[std::size_t(mate_edge_[std::size_t(t)])] / 3;
    }
    void flip_path(HalfEdge last);

    std::span<const HalfEdge> opposite_;
    std::span<const std::uint32_t> keys_;
    std::vector<HalfEdge> mate_edge_;     // each triangle's half-edge towards its mate
    std::vector<HalfEdge> parent_;        // half-edge that found each even triangle's mate
    std::vector<std::int32_t> seen_;      // number of the last search that visited each triangle
    std::vector<std::int32_t> frontier_;  // even triangles, breadth first
    std::int32_t search_ = 0;
};

// Searches an augmenting path from the single triangle `root` and flips it. Even triangles are
// reached by an even number of steps: unmatched edge, matched edge, ... A single triangle beyond
// one of them ends a path on which all edges can change sides.
void Matcher::augment_from(std::int32_t root) {
    constexpr std::size_t most_visited = 256;
    ++search_;
    seen_[std::size_t(root)] = search_;
    frontier_.assign(1, root);
    parent_[std::size_t(root)] = -1;
    for (std::size_t i = 0; i < frontier_.size() && i < most_visited; ++i) {
        const std::int32_t t = frontier_[i];
        for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
            if (!allowed(h)) continue;
            const std::int32_t other = opposite_[std::size_t(h)] / 3;
            if (seen_[std::size_t(other)] == search_) continue;
            if (single(other)) return flip_path(h);
            const std::int32_t next = mate(other);
            if (seen_[std::size_t(next)] == search_) continue;
            seen_[std::size_t(other)] = seen_[std::size_t(next)] = search_;
            parent_[std::size_t(next)] = h;
            frontier_.push_back(next);
        }
    }
}

void Matcher::flip_path(HalfEdge last) {
    for (HalfEdge h = last; h >= 0;) {
        const HalfEdge before = parent_[std::size_t(h / 3)];
        match(h);
        h = before;
    }
}

std::vector<std::int8_t> Matcher::edges() const {
    std::vector<std::int8_t> edges;
    edges.reserve(mate_edge_.size());
    for (const HalfEdge h : mate_edge_)
        edges.push_back(static_cast<std::int8_t>(h < 0 ? -1 : h % 3));
    return edges;
}

bool alike(double a, double b, double most_ratio) {
    return a > 0.0 && b > 0.0 && std::max(a, b) <= most_ratio * std::min(a, b);
}

double squared_length(const Mesh& mesh, HalfEdge h) {
    const Triangle& t = mesh.triangles[std::size_t(h / 3)];
    const Vec3d d =
        mesh.positions[t[std::size_t(h % 3)]] - mesh.positions[t[std::size_t((h + 1) % 3)]];
    return glm::dot(d, d);
}

/// Cost of a pair across a common edge, 0 to 2: 0 for equal weights and the longest edge of both
/// triangles.
double dislike(const Mesh& mesh, std::span<const float> weights, HalfEdge h, HalfEdge o) {
    const double a = weights[std::size_t(h / 3)], b = weights[std::size_t(o / 3)];
    double longest = 0.0;
    for (const HalfEdge first : {h - h % 3, o - o % 3})
        for (HalfEdge e = first; e < first + 3; ++e)
            longest = std::max(longest, squared_length(mesh, e));
    const double shortness =
        longest > 0.0 ? 1.0 - std::sqrt(squared_length(mesh, h) / longest) : 0.0;
    return 1.0 - std::min(a, b) / std::max(a, b) + shortness;
}

}  // namespace

std::vector<std::int32_t> opposite_half_edges(const Mesh& mesh, const Connectivity& connectivity) {
    std::vector<HalfEdge> beyond(3 * mesh.triangles.size(), -1);
    for_each_index(mesh.triangles.size(), [&](std::size_t t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t other = connectivity.neighbours[t][k];
            if (other < 0 || std::size_t(other) == t) continue;
            const Triangle& a = mesh.triangles[t];
            const Triangle& b = mesh.triangles[std::size_t(other)];
            for (std::size_t j = 0; j < 3; ++j)
                if (a[k] == b[(j + 1) % 3] && a[(k + 1) % 3] == b[j])
                    beyond[3 * t + k] = static_cast<HalfEdge>(3 * std::size_t(other) + j);
        }
    });
    std::vector<HalfEdge> opposite(beyond.size());
    for_each_index(beyond.size(), [&](std::size_t h) {
        const HalfEdge o = beyond[h];
        const bool mutual = o >= 0 && beyond[std::size_t(o)] == static_cast<HalfEdge>(h);
        opposite[h] = mutual ? o : -1;
    });
    return opposite;
}

std::vector<std::int8_t> match_triangles(std::span<const std::int32_t> opposite,
                                         std::span<const std::uint32_t> keys) {
    Matcher matcher(opposite, keys);
    std::vector<std::pair<std::uint32_t, HalfEdge>> candidates;
    for (HalfEdge h = 0; std::size_t(h) < opposite.size(); ++h)
        if (opposite[std::size_t(h)] >= h && matcher.allowed(h))
            candidates.emplace_back(keys[std::size_t(h)], h);
    tbb::parallel_sort(candidates.begin(), candidates.end());
    for (const auto& [key, h] : candidates)
        if (matcher.single(h / 3) && matcher.single(opposite[std::size_t(h)] / 3)) matcher.match(h);
    for (std::int32_t t = 0; std::size_t(t) < opposite.size() / 3; ++t)
        if (matcher.single(t)) matcher.augment_from(t);
    return matcher.edges();
}

std::vector<std::int8_t> pair_triangles(const Mesh& mesh, std::span<const std::int32_t> opposite,
                                        std::span<const float> weights, double most_ratio) {
    std::vector<std::uint32_t> keys(opposite.size(), never_pair);
    for (HalfEdge h = 0; std::size_t(h) < opposite.size(); ++h) {
        const HalfEdge o = opposite[std::size_t(h)];
        if (o < h || !alike(weights[std::size_t(h / 3)], weights[std::size_t(o / 3)], most_ratio))
            continue;
        keys[std::size_t(h)] = keys[std::size_t(o)] =
            static_cast<std::uint32_t>(std::ldexp(dislike(mesh, weights, h, o), 24));
    }
    return match_triangles(opposite, keys);
}

}  // namespace burl
