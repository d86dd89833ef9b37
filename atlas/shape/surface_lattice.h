#pragma once
// Values of a mask at a lattice of points of every triangle, between which texels interpolate:
// masks of a surface change over many texels, and rays are dear (Ward, Rubinstein, Clear, "A Ray
// Tracing Solution for Diffuse Interreflection", 1988, keep irradiance for the same reason). A
// triangle's lattice knows no other triangle, so nothing leaks across edges or through thin walls.
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "atlas/shape/shape_scene.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

/// A mask: fills as many values as it gets points. It may be called from several threads at once,
/// and a point's value must not depend on the other points.
using PointMask = std::function<void(std::span<const ShapePoint>, std::span<float>)>;

/// Values of the three lattice points round a place.
struct LatticeCell {
    Vec3d weights{0.0};  ///< of `values` at the place; sum 1, none negative
    Vec3f values{0.0f};
};

/// A mask's values at the lattices of all triangles that have one.
class SurfaceLattice {
  public:
    /// Takes the mask's values at lattices whose points lie about `spacing` texels of the atlas
    /// apart. Triangles that show so few texels that a lattice saves less than half have none.
    SurfaceLattice(const SolidAtlas& solid, const ShapeScene& shape, const PointMask& mask,
                   double spacing);

    bool covers(std::uint32_t triangle) const { return sides_[triangle] > 0; }
    /// The cell at these weights of the corners of a covered triangle. Negative weights become 0.
    LatticeCell at(std::uint32_t triangle, const Vec3d& weights) const;

  private:
    void choose_sides(const SolidAtlas& solid, const ShapeScene& shape, double spacing);
    void take_values(const ShapeScene& shape, const PointMask& mask);
    float value(std::uint32_t triangle, std::uint32_t i, std::uint32_t j) const;

    std::vector<std::uint32_t> sides_;  ///< cells along each triangle's edge; 0: no lattice
    std::vector<std::size_t> begin_;    ///< of each triangle's values, and the end of all
    std::vector<float> values_;
};

}  // namespace burl
