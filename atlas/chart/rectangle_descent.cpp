// L-BFGS on the stretch of a rectangle map. The first guess of the Hessian's inverse are two
// Laplacian factors, one per coordinate, because u and v are free on different sides; they are
// weighted by the surface's extent in that direction, which makes the first step right for any
// proportions.
#include <algorithm>
#include <cmath>

#include "atlas/chart/laplacian.h"
#include "atlas/chart/last_steps.h"
#include "atlas/chart/rectangle_map.h"

namespace burl {
namespace {

constexpr double keep_from_collapse = 0.8;  ///< longest step, relative to that to a collapse

using Field = VertexField;

std::vector<bool> free_vertices(const std::vector<SideMask>& sides, unsigned held_by) {
    std::vector<bool> is_free(sides.size());
    for (std::size_t v = 0; v < sides.size(); ++v) is_free[v] = (sides[v] & held_by) == 0;
    return is_free;
}

/// One descent on a map's energy.
class Descent {
  public:
    Descent(const Patch& patch, const WeightedEdges& edges, RectangleMap& map,
            const DescentOptions& options)
        : map_(map),
          aspect_(options.aspect),
          anisotropy_(options.aspect ? options.anisotropy : 0.0),
          measure_(patch),
          free_u_(free_vertices(map.sides, 0b1010)),
          free_v_(free_vertices(map.sides, 0b0101)),
          laplacian_u_(edges, free_u_),
          laplacian_v_(edges, free_v_) {}

    int run(const DescentOptions& options) {
        if (!laplacian_u_.factored() || !laplacian_v_.factored()) return 0;
        map_.stretch = measure_(map_.uv);
        if (!map_.stretch.finite()) return 0;
        energy_ = energy(map_.stretch, map_.uv);
        Field gradient = gradient_here();
        int done = 0;
        double gain_before = 0.0;
        while (done < options.iterations) {
            const double before = energy_;
            const Field old_uv = map_.uv, old_gradient = gradient;
            if (!step_along(direction(gradient), gradient)) {
                if (steps_.empty()) break;
                steps_.clear();
                continue;
            }
            ++done;
            const double gain = before - energy_;
            if (energy_ <= options.wanted && gain < options.least_gain * before) break;
            if (out_of_reach(energy_, std::max(gain, gain_before), done, options)) break;
            gain_before = gain;
            gradient = gradient_here();
            remember(old_uv, old_gradient, gradient);
        }
        return done;
    }

  private:
    /// Whether the wanted energy is out of reach at the rate of the last gains, which only get
    /// smaller once the first four iterations are over.
    static bool out_of_reach(double energy, double gain, int done, const DescentOptions& options) {
        return done >= 4 && energy - options.wanted > gain * (options.iterations - done);
    }

    double energy(const Stretch& s, const Field& uv) const {
        const double area2 = s.area * s.area;
        if (!s.finite()) return std::numeric_limits<double>::infinity();
        if (!aspect_) return s.distortion();
        const double stretch = 0.5 * (s.x / *aspect_ + s.y * *aspect_) / area2;
        return anisotropy_ > 0.0 ? stretch + anisotropy_ * measure_.anisotropy(uv, *aspect_)
                                 : stretch;
    }

    Field gradient_here() const {
        const Stretch& s = map_.stretch;
        const double aspect = aspect_.value_or(s.best_aspect()), area2 = s.area * s.area;
        Field g = measure_.gradient(map_.uv, 0.5 / (aspect * area2), 0.5 * aspect / area2);
        if (anisotropy_ > 0.0) measure_.add_anisotropy_gradient(map_.uv, aspect, anisotropy_, g);
        for (std::size_t v = 0; v < g.size(); ++v) {
            if (!free_u_[v]) g[v].x = 0.0;
            if (!free_v_[v]) g[v].y = 0.0;
        }
        return g;
    }

    void precondition(Field& field) const {
        std::vector<double> one(field.size());
        const double aspect = map_.stretch.best_aspect();
        for (std::size_t v = 0; v < field.size(); ++v) one[v] = field[v].x;
        laplacian_u_.apply_inverse(one, one);
        for (std::size_t v = 0; v < field.size(); ++v) field[v].x = one[v] / aspect;
        for (std::size_t v = 0; v < field.size(); ++v) one[v] = field[v].y;
        laplacian_v_.apply_inverse(one, one);
        for (std::size_t v = 0; v < field.size(); ++v) field[v].y = one[v] * aspect;
    }

    Field direction(const Field& gradient) const {
        return steps_.direction(gradient, [&](Field& d) {
            precondition(d);
            for (Vec2d& value : d) value *= scale_;
        });
    }

    /// Moves along d, halving the step until the energy falls enough (Armijo); false, with nothing
    /// moved, if it never does.
    bool step_along(const Field& d, const Field& gradient) {
        const double slope = dot(d, gradient), before = energy_;
        if (!(slope < 0.0)) return false;
        const double limit = keep_from_collapse * measure_.step_to_collapse(map_.uv, d);
        double step = steps_.empty() ? first_step(d, limit) : std::min(1.0, limit);
        Field moved;
        for (int halvings = 0; halvings < 30; ++halvings, step *= 0.5) {
            moved = map_.uv;
            add_scaled(moved, step, d);
            const Stretch stretch = measure_(moved);
            const double after = energy(stretch, moved);
            if (!(after <= before + 1e-4 * step * slope)) continue;
            energy_ = after;
            map_.uv = std::move(moved);
            map_.stretch = stretch;
            return true;
        }
        return false;
    }

    /// The first step along d, while its scale is unknown: at most a tenth of the rectangle.
    static double first_step(const Field& d, double limit) {
        double longest = 0.0;
        for (const Vec2d& value : d)
            longest = std::max({longest, std::abs(value.x), std::abs(value.y)});
        return std::min(limit, 0.1 / longest);
    }

    void remember(const Field& old_uv, const Field& old_gradient, const Field& gradient) {
        Field move = map_.uv, change = gradient;
        add_scaled(move, -1.0, old_uv);
        add_scaled(change, -1.0, old_gradient);
        const double product = dot(move, change);
        if (!(product > 0.0)) return;
        Field image = change;
        precondition(image);
        scale_ = product / dot(change, image);
        steps_.add(std::move(move), std::move(change), product);
    }

    RectangleMap& map_;
    std::optional<double> aspect_;
    double anisotropy_;
    double energy_ = 0.0;  ///< the map's
    StretchMeasure measure_;
    std::vector<bool> free_u_, free_v_;
    PatchLaplacian laplacian_u_, laplacian_v_;
    LastSteps steps_;
    double scale_ = 1.0;
};

}  // namespace

int descend(const Patch& patch, RectangleMap& map, const DescentOptions& options) {
    return descend(patch, weighted_edges(patch), map, options);
}

int descend(const Patch& patch, const WeightedEdges& edges, RectangleMap& map,
            const DescentOptions& options) {
    return Descent(patch, edges, map, options).run(options);
}

}  // namespace burl
