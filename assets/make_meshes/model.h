#pragma once
// A mesh being made: points, triangles, and adding to them. Points are rounded to float32, so that
// every format we write, STL's float32 included, carries the same numbers.
#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "atlas/base/vec.h"

namespace burl {

class Model {
  public:
    /// Index of this point; one already added with the same coordinates is found again.
    std::uint32_t point(const Vec3d& position);

    /// Counter-clockwise seen from outside; one with two equal corners is left out.
    void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c);

    /// Two triangles, split along the diagonal a-c.
    void quad(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d);

    const std::vector<Vec3d>& points() const { return points_; }
    const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return triangles_; }

  private:
    std::vector<Vec3d> points_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::map<std::array<double, 3>, std::uint32_t> index_;
};

/// The models stand upright (y up); lengths are in their own units.

/// Newell's teapot: 32 Bezier patches, each `segments` x `segments` quads. Four shells: pot, lid,
/// handle, spout.
Model make_teapot(int segments = 10);

/// A chess king: a lathed body with long slivers and a cross on top, two closed shells.
Model make_king(int segments = 48);

/// A head and shoulders on a foot, one closed shell; `step` is the length of its grid's cells.
Model make_bust(double step = 0.036);

/// Torus about the y axis: radii 1 and 0.4.
Model make_torus(int around = 64, int across = 32);

/// Unit sphere: an icosahedron whose triangles were split into four `levels` times.
Model make_icosphere(int levels = 4);

/// Cube from -1 to 1.
Model make_cube();

/// A plate with rounded corners, filleted edges and two holes through it: genus 2, thin long
/// triangles.
Model make_cad_part(int fillet_segments = 6);

}  // namespace burl
