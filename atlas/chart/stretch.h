#pragma once
// The stretch of a map from a rectangle to a patch, which says how badly the map samples the patch.
// For a bilinear lookup the error grows with how far the surface point s moves per texel, so the
// measure is the stretch of the *inverse* map (after Sander, Snyder, Gortler & Hoppe, "Texture
// mapping progressive meshes", 2001): X = sum A |ds/du|^2 and Y = sum A |ds/dv|^2 over the unit
// square. D = sqrt(XY) / A^2 does not depend on the rectangle's proportions; by Cauchy-Schwarz it
// is at least 1, and 1 only for a map that is a flat rectangle's own. A flipped triangle has
// infinite stretch.
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "atlas/chart/patch.h"

namespace burl {

/// Weight of triangles that close holes, relative to their area.
inline constexpr double fan_weight = 0.02;

/// The smallest positive root of a + b t + c t^2 with a > 0, or infinity.
double first_root(double a, double b, double c);

/// X and Y of a map, and the area of the patch.
struct Stretch {
    double x = std::numeric_limits<double>::infinity();  ///< X in mesh units^4
    double y = std::numeric_limits<double>::infinity();  ///< Y in mesh units^4
    double area = 0.0;  ///< area in mesh units^2, with the weights of holes' fans

    bool finite() const { return x < std::numeric_limits<double>::infinity(); }
    /// The distortion D >= 1; infinite when a triangle is flipped or collapsed.
    double distortion() const;
    /// Width over height of the rectangle that samples both directions alike.
    double best_aspect() const;
};

/// Computes the stretch of maps of one patch, and its gradient.
class StretchMeasure {
  public:
    /// Lays the patch's triangles flat; the patch need not outlive the object.
    explicit StretchMeasure(const Patch& patch);

    /// The stretch of the map that puts the vertices at `uv` in the unit square.
    Stretch operator()(std::span<const Vec2d> uv) const;

    /// The stretch of each triangle: the distance that the surface point moves per step in the
    /// square, as the root mean square over all directions of a rectangle with this aspect. No
    /// triangle may be flipped.
    std::vector<double> of_triangles(std::span<const Vec2d> uv, double aspect) const;

    /// The gradient d(factor_x X + factor_y Y)/d(uv) at each vertex. No triangle may be flipped.
    std::vector<Vec2d> gradient(std::span<const Vec2d> uv, double factor_x, double factor_y) const;

    /// The mean over the area of k^2, where k = (s1 / s2 + s2 / s1) / 2 for the singular values s1
    /// and s2 of a triangle's map onto a rectangle with this aspect (k is the energy of Hormann &
    /// Greiner, "MIPS: an efficient global parametrization method", 2000); 1 where all angles are
    /// kept. Holes' fans and slivers count as if they kept them. No triangle may be flipped.
    double anisotropy(std::span<const Vec2d> uv, double aspect) const;

    /// Adds factor times the gradient of anisotropy() at each vertex.
    void add_anisotropy_gradient(std::span<const Vec2d> uv, double aspect, double factor,
                                 std::span<Vec2d> gradient) const;

    /// The largest t for which no triangle of uv + t direction has collapsed yet; infinite if none
    /// ever does.
    double step_to_collapse(std::span<const Vec2d> uv, std::span<const Vec2d> direction) const;

  private:
    /// A triangle laid flat: corner 0 at the origin, corner 1 at p1, corner 2 at p2.
    struct Flat {
        Triangle vertices;
        Vec2d p1, p2;
        double weight;
        double area;  ///< 0 where the anisotropy does not count
    };
    /// k of a triangle that lies in the square as a and b from its first corner, with derivatives.
    struct Conformal {
        double k = 1.0;
        Vec2d by_a{0.0}, by_b{0.0};
    };
    static Conformal conformal(const Flat& flat, const Vec2d& a, const Vec2d& b, double aspect);

    std::vector<Flat> triangles_;
    double area_ = 0.0;
};

}  // namespace burl
