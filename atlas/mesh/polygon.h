#pragma once
// Triangulation of one polygon of a mesh file: a fan where the polygon is strictly convex, ear
// clipping (Meisters 1975) otherwise, in the plane of Newell's normal.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/base/vec.h"

namespace burl {

/// A grid of equal cells over the bounding box of points of the plane; members can be dropped, not
/// added. Ear clipping asks it for the corners near a box, which can keep an ear from being cut.
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

/// Cuts polygons into triangles; holds its working memory, so that a reader makes one and keeps it.
class PolygonTriangulator {
  public:
    /// The n - 2 triangles of a polygon of n >= 3 corners, as corner numbers 0..n-1, wound as the
    /// polygon. Area is kept for any simple polygon, also with collinear or repeated corners and
    /// with holes joined by a bridge; a self-crossing one still gives n - 2 triangles. The result
    /// is valid until the next call.
    const std::vector<std::array<std::uint32_t, 3>>& operator()(std::span<const Vec3d> corners);

    /// Number of polygons so far that cross themselves or exceed the work limit: some of their
    /// triangles may overlap or be turned over.
    std::uint64_t forced() const { return forced_; }

  private:
    bool project(std::span<const Vec3d> corners);
    bool strictly_convex() const;
    void fan(std::uint32_t count);
    void clip_ears();
    void start_ring(std::uint32_t count);
    std::vector<std::uint32_t> ring() const;
    void run_lap(int strictness);
    bool is_ear(std::uint32_t tip, int strictness);
    void find_blockers();
    void spend(std::uint64_t work) { work_left_ -= work < work_left_ ? work : work_left_; }
    double turn(std::uint32_t corner) const;
    bool blocks(std::uint32_t other, std::uint32_t tip, int strictness) const;
    void cut(std::uint32_t tip);

    std::vector<Vec2d> plane_;
    /// Linked ring of the corners left; a cut corner is its own next.
    std::vector<std::uint32_t> next_, previous_;
    std::uint32_t start_ = 0, left_ = 0;          ///< a corner of the ring, and the ring's length
    std::vector<std::uint32_t> lap_, following_;  ///< corners to try in this lap and in the next
    std::vector<bool> touched_;                   ///< whether a corner is in following_
    std::vector<std::uint32_t> blockers_;         ///< reflex and straight corners
    PointGrid blocker_grid_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::uint64_t work_left_ = 0;
    std::uint64_t forced_ = 0;
};

}  // namespace burl
