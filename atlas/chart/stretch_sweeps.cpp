// The energy of a triangle as a function of one vertex: with q the vertex, a and b the other
// corners and G the Gram matrix of the surface's edges from q, it is f / d^2, where f = |G1 (b-q).y
// - G2 (a-q).y|^2 / aspect + |G1 (b-q).x - G2 (a-q).x|^2 aspect, a quadratic in q, and d = (a-q) x
// (b-q), which is linear in q.
#include "atlas/chart/stretch_sweeps.h"

#include <cmath>
#include <limits>

#include "atlas/chart/corner_search.h"
#include "atlas/chart/stretch.h"

namespace burl {
namespace {

constexpr int most_step_halvings = 6;
constexpr double least_gain = 0.01;

/// A triangle seen from one of its corners: the other two corners, and the surface's edges to them.
struct Wedge {
    std::uint32_t a = 0, b = 0;
    double weight = 0.0;
    double aa = 0.0, ab = 0.0, bb = 0.0;  ///< dot products of the edges
};

/// Value, gradient and Hessian (xx, xy, yy) of a vertex's energy.
struct Local {
    double value = 0.0;
    Vec2d gradient{0.0};
    double xx = 0.0, xy = 0.0, yy = 0.0;
};

/// Moves the inner vertices of a map one after the other.
class Sweeper {
  public:
    Sweeper(const Patch& patch, std::span<Vec2d> uv, double aspect)
        : patch_(patch),
          uv_(uv),
          aspect_(aspect),
          inner_(inner_vertices(patch)),
          awake_(uv.size(), true) {
        begin_.assign(patch.points.size() + 1, 0);
        for (const Triangle& t : patch.triangles)
            for (const std::uint32_t v : t) ++begin_[v + 1];
        for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
        wedges_.resize(begin_.back());
        std::vector<std::uint32_t> place(begin_.begin(), begin_.end() - 1);
        for (std::size_t t = 0; t < patch.triangles.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k)
                wedges_[place[patch.triangles[t][k]]++] = wedge(t, k);
    }

    /// One sweep; false when all vertices rest.
    bool run() {
        std::vector<bool> visit = std::move(awake_);
        awake_.assign(uv_.size(), false);
        bool any = false;
        for (std::uint32_t v = 0; v < uv_.size(); ++v) {
            if (!visit[v] || !inner_[v] || !move(v)) continue;
            any = awake_[v] = true;
            for (const Wedge& w : wedges_of(v)) awake_[w.a] = true;
        }
        return any;
    }

  private:
    Wedge wedge(std::size_t t, std::size_t k) const {
        const Triangle& v = patch_.triangles[t];
        const std::uint32_t a = v[(k + 1) % 3], b = v[(k + 2) % 3];
        const Vec3d ea = patch_.points[a] - patch_.points[v[k]];
        const Vec3d eb = patch_.points[b] - patch_.points[v[k]];
        const double weight = patch_.faces[t] == not_in_mesh ? fan_weight : 1.0;
        return {a,
                b,
                weight * glm::length(glm::cross(ea, eb)),
                glm::dot(ea, ea),
                glm::dot(ea, eb),
                glm::dot(eb, eb)};
    }

    std::span<const Wedge> wedges_of(std::uint32_t v) const {
        return {wedges_.data() + begin_[v], begin_[v + 1] - begin_[v]};
    }

    /// The numbers f and d of a wedge with its corner at q.
    std::pair<double, double> quotient(const Wedge& w, const Vec2d& q) const {
        const Vec2d a = uv_[w.a] - q, b = uv_[w.b] - q;
        const double along_u = w.aa * b.y * b.y - 2.0 * w.ab * a.y * b.y + w.bb * a.y * a.y;
        const double along_v = w.aa * b.x * b.x - 2.0 * w.ab * a.x * b.x + w.bb * a.x * a.x;
        return {along_u / aspect_ + along_v * aspect_, a.x * b.y - a.y * b.x};
    }

    double value(std::uint32_t v, const Vec2d& q) const {
        double sum = 0.0;
        for (const Wedge& w : wedges_of(v)) {
            const auto [f, d] = quotient(w, q);
            if (!(d > 0.0)) return std::numeric_limits<double>::infinity();
            sum += w.weight * f / (d * d);
        }
        return sum;
    }

    Local local(std::uint32_t v) const {
        Local sum;
        const Vec2d q = uv_[v];
        for (const Wedge& w : wedges_of(v)) {
            const auto [f, d] = quotient(w, q);
            const Vec2d a = uv_[w.a] - q, b = uv_[w.b] - q;
            const double second = 2.0 * (w.aa - 2.0 * w.ab + w.bb);
            const double fxx = second * aspect_, fyy = second / aspect_;
            const Vec2d df(-2.0 * aspect_ * (w.aa * b.x - w.ab * (a.x + b.x) + w.bb * a.x),
                           -2.0 / aspect_ * (w.aa * b.y - w.ab * (a.y + b.y) + w.bb * a.y));
            const Vec2d dd(a.y - b.y, b.x - a.x);
            const double d2 = w.weight / (d * d), d3 = d2 / d, d4 = d3 / d;
            sum.value += f * d2;
            sum.gradient += df * d2 - 2.0 * f * d3 * dd;
            sum.xx += fxx * d2 - 4.0 * df.x * dd.x * d3 + 6.0 * f * dd.x * dd.x * d4;
            sum.yy += fyy * d2 - 4.0 * df.y * dd.y * d3 + 6.0 * f * dd.y * dd.y * d4;
            sum.xy += -2.0 * (df.x * dd.y + df.y * dd.x) * d3 + 6.0 * f * dd.x * dd.y * d4;
        }
        return sum;
    }

    /// Moves the vertex by a Newton step; true if that gained enough for another visit.
    bool move(std::uint32_t v) {
        const Local here = local(v);
        const double determinant = here.xx * here.yy - here.xy * here.xy;
        if (!(here.xx > 0.0) || !(determinant > 0.0) || !std::isfinite(determinant)) return false;
        const Vec2d step(-(here.yy * here.gradient.x - here.xy * here.gradient.y) / determinant,
                         -(here.xx * here.gradient.y - here.xy * here.gradient.x) / determinant);
        double share = 1.0;
        for (int i = 0; i < most_step_halvings; ++i, share *= 0.5) {
            const Vec2d q = uv_[v] + share * step;
            const double there = value(v, q);
            if (!(there < here.value)) continue;
            uv_[v] = q;
            return there < (1.0 - least_gain) * here.value;
        }
        return false;
    }

    const Patch& patch_;
    std::span<Vec2d> uv_;
    double aspect_;
    std::vector<bool> inner_, awake_;
    std::vector<std::uint32_t> begin_;
    std::vector<Wedge> wedges_;  ///< vertex v has wedges_[begin_[v]] up to wedges_[begin_[v + 1]]
};

}  // namespace

void sweep_stretch(const Patch& patch, std::span<Vec2d> uv, double aspect, int sweeps) {
    Sweeper sweeper(patch, uv, aspect);
    for (int i = 0; i < sweeps && sweeper.run();) ++i;
}

}  // namespace burl
