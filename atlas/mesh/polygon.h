#pragma once
// Triangulation of one polygon of a mesh file: a fan where the polygon is strictly convex, ear
// clipping (Meisters 1975) otherwise, in the plane of Newell's normal.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/base/vec.h"
#include "atlas/mesh/point_grid.h"

namespace burl {

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
