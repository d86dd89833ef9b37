#pragma once
// The effect of a paint stroke at a point of the surface: the coverage by a ball swept along a
// polyline, and the compositing of colours (Porter & Duff, "Compositing Digital Images", 1984, the
// operator `over`, in linear light).
#include <span>
#include <vector>

#include "app/recipe/paint_stroke.h"
#include "atlas/mesh/mesh.h"
#include "procedural/numbers/dual.h"

namespace burl {

/// Premultiplied colour in linear light, and alpha: the paint over the texture.
using PaintLight = Vec4f;

/// A straight part of a stroke's polyline; a stroke of one point has one segment of length 0.
struct PaintSegment {
    Vec3d from{0.0}, to{0.0};
};

/// A stroke prepared for evaluation at many points.
class PaintBrush {
  public:
    explicit PaintBrush(const PaintStroke& stroke);

    std::span<const PaintSegment> segments() const { return segments_; }
    /// The diagonal of the segments' bounding box.
    const PaintSegment& hull() const { return hull_; }
    double radius() const { return radius_; }

    /// The coverage, 0..1, of a point at this squared distance from the stroke's polyline: 1 up to
    /// hardness times the radius, then a smoothstep down to 0 at the radius. The smoothstep is at
    /// least one texel wide, so that hard edges are antialiased. `texel` is in solid units.
    double coverage(double squared_distance, double texel) const;
    /// The coverage at a point near some of the stroke's segments, of which there is at least one,
    /// with its gradient in solid space.
    Dual coverage(const Vec3d& point, std::span<const PaintSegment> near, double texel) const;
    /// The paint after laying the stroke over `below`, or erasing from it, with this coverage.
    PaintLight over(const PaintLight& below, double coverage) const;
    /// The alpha of `over`, for a layer that has no colours.
    Dual over(const Dual& below, const Dual& coverage) const;

  private:
    std::vector<PaintSegment> segments_;
    PaintSegment hull_;
    double radius_, inner_, opacity_;
    Vec3f light_;
    bool erases_;
};

/// From the nearest point of a segment to the point.
Vec3d apart_from(const Vec3d& point, const PaintSegment& segment);

/// The squared distance of a point from a segment.
double squared_distance(const Vec3d& point, const PaintSegment& segment);

/// Whether the box whose diagonal is the segment may come within `radius` of `box`; conservative:
/// never false where it does.
bool may_reach(const PaintSegment& segment, double radius, const Box3& box);

/// The colour in linear light of `below` under the paint.
inline Vec3f painted(const PaintLight& paint, const Vec3f& below) {
    return Vec3f(paint) + (1.0f - paint.a) * below;
}

}  // namespace burl
