#pragma once
// Cosine-weighted directions about a normal: a spiral of points at golden angles (Vogel, "A better
// way to construct the sunflower head", 1979), which is as even as a lattice, lifted from the disc
// onto the hemisphere (Malley's method; Pharr, Jakob, Humphreys, "Physically Based Rendering",
// section 13.6.3), and turned by a random angle at every point of the surface.
#include <span>
#include <vector>

#include "atlas/base/vec.h"

namespace burl {

/// Three perpendicular unit vectors, the third along a normal.
struct Frame {
    Vec3f x{0.0f}, y{0.0f}, z{0.0f};
    Vec3f operator()(const Vec3f& v) const { return v.x * x + v.y * y + v.z * z; }
};

/// The directions about a normal and the frame they are meant in.
struct Directions {
    std::span<const Vec3f> local;  ///< of length 1, z > 0
    Frame frame;
};

/// Sets of directions, of which each point of a surface takes one by a hash of its place.
class Hemisphere {
  public:
    /// Makes sets of `count` directions, at least one.
    explicit Hemisphere(int count);
    /// The directions about `normal`, a unit vector, at `position`, which decides alone about set
    /// and turn.
    Directions at(const Vec3d& position, const Vec3d& normal) const;

  private:
    std::size_t count_;
    std::vector<Vec3f> sets_;
};

}  // namespace burl
