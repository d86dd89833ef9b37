#pragma once
// A uniform grid over points of the plane, for "what lies near this box?" while points drop out:
// ear clipping asks it for the corners that can keep an ear from being cut.
#include <cstdint>
#include <vector>

#include "atlas/base/vec.h"

namespace burl {

/// A grid of equal cells over the points' bounding box; members can be dropped, not added.
class PointGrid {
  public:
    /// Fills the grid with `members`, indices into `points`; about one member per cell.
    void fill(const std::vector<Vec2d>& points, const std::vector<std::uint32_t>& members);

    /// Number of cells that the box touches, a lower bound of the cost of visiting it.
    std::uint64_t cells_in(const Vec2d& low, const Vec2d& high) const {
        return std::uint64_t{column(high.x) - column(low.x) + 1} * (row(high.y) - row(low.y) + 1);
    }

    /// A visitor's answer: the member stays, leaves the grid, or ends the visit.
    enum class Verdict { keep, drop, stop };

    /// Calls visit(member) for the members of all cells that the box touches, until it answers
    /// stop; members it answers drop to leave the grid. Returns whether it answered stop.
    template <typename Visit>
    bool visit(const Vec2d& low, const Vec2d& high, const Visit& visit) {
        const std::uint32_t x0 = column(low.x), x1 = column(high.x);
        const std::uint32_t y0 = row(low.y), y1 = row(high.y);
        for (std::uint32_t y = y0; y <= y1; ++y)
            for (std::uint32_t x = x0; x <= x1; ++x)
                if (visit_cell(y * side_ + x, visit)) return true;
        return false;
    }

  private:
    template <typename Visit>
    bool visit_cell(std::uint32_t cell, const Visit& visit) {
        for (std::uint32_t i = begin_[cell]; i < end_[cell];) {
            const Verdict verdict = visit(members_[i]);
            if (verdict == Verdict::stop) return true;
            if (verdict == Verdict::drop)
                members_[i] = members_[--end_[cell]];
            else
                ++i;
        }
        return false;
    }
    std::uint32_t column(double x) const { return place((x - low_.x) * cells_per_unit_.x); }
    std::uint32_t row(double y) const { return place((y - low_.y) * cells_per_unit_.y); }
    std::uint32_t place(double cells) const {
        return cells > 0.0 ? static_cast<std::uint32_t>(glm::min(cells, side_ - 1.0)) : 0;
    }

    std::uint32_t side_ = 1;  ///< cells per row and per column
    Vec2d low_{0.0}, cells_per_unit_{0.0};
    std::vector<std::uint32_t> begin_, end_, members_;  ///< cell c: members_[begin_[c] .. end_[c])
};

}  // namespace burl
