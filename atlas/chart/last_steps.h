#pragma once
// The memory of L-BFGS (Nocedal, "Updating quasi-Newton matrices with limited storage", 1980), for
// descents on maps of patches.
#include <deque>
#include <utility>
#include <vector>

#include "atlas/base/vec.h"

namespace burl {

/// A value for each vertex of a patch.
using VertexField = std::vector<Vec2d>;

inline double dot(const VertexField& a, const VertexField& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i], b[i]);
    return sum;
}

inline void add_scaled(VertexField& a, double factor, const VertexField& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
}

/// The last steps of a descent, from which the Hessian is estimated.
class LastSteps {
  public:
    bool empty() const { return steps_.empty(); }
    void clear() { steps_.clear(); }

    /// Remembers a step with the change of the gradient along it; `product` is their scalar
    /// product, which must be positive.
    void add(VertexField move, VertexField change, double product) {
        steps_.push_back({std::move(move), std::move(change), 1.0 / product});
        if (steps_.size() > most) steps_.pop_front();
    }

    /// The direction of descent by the two-loop recursion; precondition(field) applies the first
    /// guess of the Hessian's inverse in place.
    template <class Precondition>
    VertexField direction(const VertexField& gradient, const Precondition& precondition) const {
        VertexField d = gradient;
        std::vector<double> share(steps_.size());
        for (std::size_t i = steps_.size(); i-- > 0;) {
            share[i] = steps_[i].inverse_product * dot(steps_[i].move, d);
            add_scaled(d, -share[i], steps_[i].change);
        }
        precondition(d);
        for (std::size_t i = 0; i < steps_.size(); ++i)
            add_scaled(d, share[i] - steps_[i].inverse_product * dot(steps_[i].change, d),
                       steps_[i].move);
        for (Vec2d& value : d) value = -value;
        return d;
    }

  private:
    static constexpr std::size_t most = 6;
    struct Step {
        VertexField move, change;
        double inverse_product;
    };
    std::deque<Step> steps_;
};

}  // namespace burl
