// A round visits vertices by the area of their triangles, smallest first, and locks the ring of
// every vertex that is removed.
#include "atlas/chart/edge_collapse.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace burl {
namespace {

constexpr std::size_t most_ring = 12;
constexpr double least_cosine = 0.9;     ///< cosine of the largest turn of a triangle
constexpr double most_area = 2.0;        ///< area of a vertex, relative to the mean
constexpr double least_progress = 0.03;  ///< smallest share of the triangles that a round removes

/// Quality of a triangle, 0 to 1 (equilateral): 4 sqrt(3) area / sum of squared sides. `normal` has
/// the length of twice the area.
double shape(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& normal) {
    const double sides = glm::dot(b - a, b - a) + glm::dot(c - b, c - b) + glm::dot(a - c, a - c);
    return sides > 0.0 ? 2.0 * std::sqrt(3.0) * glm::length(normal) / sides : 0.0;
}

/// Collapses a mesh round by round.
class Collapser {
  public:
    Collapser(std::span<const Vec3d> points, std::span<const Triangle> triangles,
              std::vector<bool> closed)
        : points_(points),
          triangles_(triangles.begin(), triangles.end()),
          closed_(std::move(closed)) {
        closed_.resize(points.size(), false);
        alive_.resize(triangles_.size());
        std::iota(alive_.begin(), alive_.end(), 0u);
        result_.heir = alive_;
    }

    CollapsedMesh run(std::size_t most) {
        while (alive_.size() > most) {
            const std::size_t before = alive_.size();
            round(most);
            if (double(before - alive_.size()) < least_progress * double(before)) break;
        }
        for (const std::uint32_t t : alive_) result_.triangles.push_back(triangles_[t]);
        result_.which = std::move(alive_);
        for (std::uint32_t& heir : result_.heir)
            while (result_.heir[heir] != heir) heir = result_.heir[heir];
        return std::move(result_);
    }

  private:
    void round(std::size_t most) {
        list_triangles_of_vertices();
        std::vector<double> area(points_.size(), 0.0);
        double all = 0.0;
        for (const std::uint32_t t : alive_) {
            const double a = glm::length(normal(triangles_[t]));
            all += a;
            for (const std::uint32_t v : triangles_[t]) area[v] += a;
        }
        std::vector<std::pair<double, std::uint32_t>> order;
        std::size_t used = 0;
        for (std::uint32_t v = 0; v < points_.size(); ++v) used += begin_[v + 1] > begin_[v];
        for (std::uint32_t v = 0; v < points_.size(); ++v)
            if (begin_[v + 1] > begin_[v] && area[v] * double(used) <= most_area * 3.0 * all)
                order.emplace_back(area[v], v);
        std::sort(order.begin(), order.end());
        locked_.assign(points_.size(), false);
        grown_ = closed_;
        std::size_t left = alive_.size();
        for (const auto& [size, v] : order) {
            if (left <= most) break;
            if (!locked_[v] && collapse(v)) left -= 2;
        }
        std::erase_if(alive_, [&](std::uint32_t t) { return result_.heir[t] != t; });
    }

    /// Lists the triangles of each vertex v: of_vertex_[begin_[v]] up to of_vertex_[begin_[v + 1]].
    void list_triangles_of_vertices() {
        begin_.assign(points_.size() + 1, 0);
        for (const std::uint32_t t : alive_)
            for (const std::uint32_t v : triangles_[t]) ++begin_[v + 1];
        for (std::size_t v = 0; v < points_.size(); ++v) begin_[v + 1] += begin_[v];
        of_vertex_.resize(begin_.back());
        std::vector<std::uint32_t> place(begin_.begin(), begin_.end() - 1);
        for (const std::uint32_t t : alive_)
            for (const std::uint32_t v : triangles_[t]) of_vertex_[place[v]++] = t;
    }

    std::span<const std::uint32_t> triangles_of(std::uint32_t v) const {
        return {of_vertex_.data() + begin_[v], begin_[v + 1] - begin_[v]};
    }

    Vec3d normal(const Triangle& t) const {
        return glm::cross(points_[t[1]] - points_[t[0]], points_[t[2]] - points_[t[0]]);
    }

    /// Orders the triangles round an inner vertex; false for a border vertex. Triangle star_[i] is
    /// (v, ring_[i], ring_[i + 1]).
    bool walk_ring(std::uint32_t v) {
        const auto triangles = triangles_of(v);
        if (triangles.size() < 3 || triangles.size() > most_ring) return false;
        ring_.clear();
        star_.clear();
        const auto sides = [&](std::uint32_t t) {
            const Triangle& c = triangles_[t];
            const std::size_t k = c[0] == v ? 0 : c[1] == v ? 1 : 2;
            return std::pair(c[(k + 1) % 3], c[(k + 2) % 3]);
        };
        std::uint32_t next = sides(triangles[0]).first;
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const auto t =
                std::find_if(triangles.begin(), triangles.end(),
                             [&](std::uint32_t other) { return sides(other).first == next; });
            if (t == triangles.end()) return false;
            ring_.push_back(next);
            star_.push_back(*t);
            next = sides(*t).second;
        }
        return next == ring_[0];
    }

    /// Whether, among the ring's vertices, ring_[i] is joined to its two neighbours in the ring
    /// only.
    bool joined_rightly(std::size_t i) const {
        const std::size_t n = ring_.size();
        for (const std::uint32_t t : triangles_of(ring_[i]))
            for (const std::uint32_t w : triangles_[t]) {
                if (w == ring_[i]) continue;
                const auto at = std::find(ring_.begin(), ring_.end(), w);
                if (at == ring_.end()) continue;
                const std::size_t j = std::size_t(at - ring_.begin());
                if (j != (i + 1) % n && i != (j + 1) % n) return false;
            }
        return true;
    }

    /// The worst quality of the triangles that collapsing the vertex into ring_[i] would leave;
    /// negative where that turns one too far.
    double worst_shape(std::size_t i) const {
        const std::size_t n = ring_.size();
        double worst = 1.0;
        for (std::size_t j = 0; j < n; ++j) {
            if (j == i || (j + 1) % n == i) continue;
            const Triangle after{ring_[i], ring_[j], ring_[(j + 1) % n]};
            const Vec3d now = normal(after), was = normal(triangles_[star_[j]]);
            if (!(glm::dot(now, was) >= least_cosine * glm::length(now) * glm::length(was)) ||
                now == Vec3d(0.0))
                return -1.0;
            worst = std::min(worst,
                             shape(points_[after[0]], points_[after[1]], points_[after[2]], now));
        }
        return worst;
    }

    bool collapse(std::uint32_t v) {
        if (!walk_ring(v)) return false;
        const std::size_t n = ring_.size();
        std::size_t best = n;
        double best_shape = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            if (grown_[ring_[i]]) continue;
            const double s = worst_shape(i);
            if (s > best_shape && joined_rightly(i)) {
                best = i;
                best_shape = s;
            }
        }
        if (best == n) return false;
        // The two triangles at the neighbour are removed; those beside them stand for them.
        result_.heir[star_[best]] = star_[(best + 1) % n];
        result_.heir[star_[(best + n - 1) % n]] = star_[(best + n - 2) % n];
        for (std::size_t j = 0; j < n; ++j) {
            locked_[ring_[j]] = true;
            if (j != best && (j + 1) % n != best)
                triangles_[star_[j]] = {ring_[best], ring_[j], ring_[(j + 1) % n]};
        }
        grown_[ring_[best]] = true;
        result_.collapses.push_back(
            {v, static_cast<std::uint32_t>(result_.ring.size()), static_cast<std::uint32_t>(n)});
        for (std::size_t j = 0; j < n; ++j) result_.ring.push_back(ring_[(best + j) % n]);
        return true;
    }

    std::span<const Vec3d> points_;
    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> alive_;
    std::vector<std::uint32_t> begin_, of_vertex_;  ///< state at the round's start
    /// Whether no vertex may be collapsed into the vertex, by the caller's choice.
    std::vector<bool> closed_;
    /// Whether the vertex's ring has lost a vertex in this round.
    std::vector<bool> locked_;
    /// Whether the vertex is closed, or another was collapsed into it in this round.
    std::vector<bool> grown_;
    std::vector<std::uint32_t> ring_, star_;
    CollapsedMesh result_;
};

}  // namespace

CollapsedMesh collapse_edges(std::span<const Vec3d> points, std::span<const Triangle> triangles,
                             std::size_t most, std::vector<bool> closed) {
    return Collapser(points, triangles, std::move(closed)).run(most);
}

}  // namespace burl
