#pragma once
// Shapes strewn over the plane: one in each unit square, of random place, size and turn, where a
// random number says so.
#include <cstdint>

namespace burl {

/// The forms of shapes; each lies within a circle of its radius and touches it.
enum class ShapeForm {
    disk,    ///< a disk
    square,  ///< a square
    ring,    ///< an annulus, half as wide as its radius
    star,    ///< a pentagram
    leaf,    ///< the lens between two circles, half as wide as it is long
};

/// The number that the shapes about a point give.
enum class ShapeGives {
    cover,  ///< the largest of the distances to the shapes' borders, positive inside
    edge,   ///< the distance to the border of the top shape, positive inside
    id,     ///< a random number in [0, 1) of the top shape
};

/// Shapes with their random ranges, in units of squares. Of the shapes that hold a point the one
/// with the largest id is the top one; where none does, it is the nearest shape.
struct ScatteredShapes {
    std::uint32_t seed = 0;
    ShapeForm form = ShapeForm::disk;
    double radius = 0.25, spread = 0.2;  ///< least radius; what the largest, at most 3/4, has more
    double turn = 0.0;                   ///< the largest random turn in radians
    double jitter = 1.0;                 ///< side of the square of the shape's middles, 0 to 1
    double chance = 1.0;                 ///< share of squares with a shape
    ShapeGives gives = ShapeGives::cover;
    bool operator==(const ScatteredShapes&) const = default;

    /// The distance up to which distances from outside of shapes are exact: shapes of squares that
    /// are not looked at are as far away. `edge` is nowhere less than its negative.
    double outside() const { return 1.0 - (radius + spread); }
    /// An estimate of the share of the plane that shapes cover, from their mean area A per square:
    /// A where no two can overlap, otherwise midway between min(A, 1) and 1 - exp(-A). It errs by
    /// at most 0.06 with jitter 1, 0.002 up to radii of 0.45, and 0.17 where large shapes stand in
    /// rows (measured).
    double mean() const;
};

/// A number with its derivatives along x and y.
struct ShapeSample {
    double value = 0.0, gx = 0.0, gy = 0.0;
};

/// The distance to the border of the form of radius 1, positive inside, with its gradient, of
/// length 1 (0 where there is none).
ShapeSample shape_distance(ShapeForm form, double x, double y);

/// The number of `shapes` at a point. Squares up to one away are looked at: shapes reach no
/// farther.
ShapeSample scattered_at(const ScatteredShapes& shapes, double x, double y);

}  // namespace burl
