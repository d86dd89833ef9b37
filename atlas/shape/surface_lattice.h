#pragma once
// Values of a mask at a lattice of points of every triangle, between which texels interpolate:
// masks of a surface change over many texels, and rays are dear (Ward, Rubinstein, Clear, "A Ray
// Tracing Solution for Diffuse Interreflection", 1988, keep irradiance for the same reason). A
// triangle's lattice knows no other triangle, so nothing leaks across edges or through thin walls.
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "atlas/shape/shape_scene.h"
#include "atlas/solid/solid_atlas.h"
#include "atlas/solid/texel_owners.h"

namespace burl {

/// A mask: fills as many values as it gets points. It may be called from several threads at once,
/// and a point's value must not depend on the other points.
using PointMask = std::function<void(std::span<const ShapePoint>, std::span<float>)>;

/// The gradients of a mask with respect to the point, in mesh units: fills as many as it gets
/// points, as PointMask does.
using PointSlopes = std::function<void(std::span<const ShapePoint>, std::span<Vec3d>)>;

/// The triangle that a texel shows, and the weights of its corners, some negative beyond it.
struct ShownPlace {
    std::uint32_t triangle = 0;
    Vec3d weights{0.0};
};

/// The triangle that texel (x, y) shows by map number `map`: the map's triangle where the texel's
/// point lies in it, such as one that is shown a second time to fill up a block, else the texel's
/// owner.
ShownPlace place_shown(const SolidAtlas& solid, const TexelOwners& owners, const ShapeScene& shape,
                       std::uint32_t x, std::uint32_t y, std::uint32_t map);

/// A point of a lattice: cells along the triangle's first edge and along its last one.
using LatticePlace = std::array<std::uint32_t, 2>;

/// The three lattice points round a place.
struct LatticeCell {
    Vec3d weights{0.0};  ///< of the points; sum 1, none negative
    std::array<LatticePlace, 3> places{};
    Vec3f values{0.0f};  ///< the mask's at the points
};

/// How a lattice is made.
struct LatticeOptions {
    double spacing = 4.0;  ///< of the lattice points, about, in texels of the atlas
    /// Whether triangles have a lattice, too, in which it saves less than half of the points.
    bool for_slopes = false;
    std::stop_token stop{};  ///< once it is requested, the values must not be used
};

/// A mask's values at the lattices of all triangles that have one.
class SurfaceLattice {
  public:
    /// Takes the mask's values at lattices. `owners` are those of the SolidAtlas's texels.
    SurfaceLattice(const SolidAtlas& solid, const TexelOwners& owners, const ShapeScene& shape,
                   const PointMask& mask, const LatticeOptions& options);

    /// Whether a lattice saves at least half of the triangle's points.
    bool covers(std::uint32_t triangle) const { return covered_[triangle]; }
    /// The cell at these weights of the corners of a triangle that shows texels, in any lattice for
    /// slopes, or of a covered one. Negative weights become 0.
    LatticeCell at(std::uint32_t triangle, const Vec3d& weights) const;
    /// The gradient at these weights of a triangle that shows texels, in any lattice for slopes, in
    /// mesh units: central differences at lattice points, one-sided ones on the triangle's sides,
    /// and between them their mean, moved so that at the triangle's corners it is the mean over all
    /// triangles that meet there and face about the same way. Along directions in which a cell is
    /// much shorter than a tenth of a mean texel it fades to 0.
    Vec3d slope(std::uint32_t triangle, const Vec3d& weights) const;

  private:
    void choose_sides(const SolidAtlas& solid, const TexelOwners& owners, const ShapeScene& shape,
                      const LatticeOptions& options);
    void take_values(const ShapeScene& shape, const PointMask& mask, const std::stop_token& stop);
    void mend_corners(const ShapeScene& shape);
    float value(std::uint32_t triangle, const LatticePlace& at) const;
    double change(std::uint32_t triangle, const LatticePlace& at, std::size_t axis) const;
    Vec3d own_slope(std::uint32_t triangle, const LatticeCell& cell) const;

    std::vector<std::uint32_t> sides_;  ///< cells along each triangle's edge; 0: no lattice
    std::vector<bool> covered_;
    std::vector<std::size_t> begin_;  ///< of each triangle's values, and the end of all
    std::vector<float> values_;
    double least_ = 0.0;                       ///< a tenth of a mean texel's side, in mesh units
    std::vector<std::array<Vec3d, 2>> edges_;  ///< of each triangle, for slopes, in mesh units
    std::vector<Vec3f> mends_;                 ///< of slopes at corners (3t+k), for slopes
};

}  // namespace burl
