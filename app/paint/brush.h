#pragma once
// What a stroke of paint does to a point of the surface: how much of it a ball moved along a line
// covers, and how colours lie over one another (Porter & Duff, "Compositing Digital Images", 1984,
// the operator `over`, in linear light).
#include <span>
#include <vector>

#include "app/recipe/paint_stroke.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// Colour in linear light times alpha, then alpha: what paint lays over the texture.
using PaintLight = Vec4f;

/// A straight part of a stroke's line; a stroke of one point has one of length 0.
struct PaintSegment {
    Vec3d from{0.0}, to{0.0};
};

/// A stroke made ready for many points.
class PaintBrush {
  public:
    explicit PaintBrush(const PaintStroke& stroke);

    std::span<const PaintSegment> segments() const { return segments_; }
    /// The diagonal of their box.
    const PaintSegment& hull() const { return hull_; }
    double radius() const { return radius_; }

    /// Share of a point covered that lies so far (squared) from the stroke's line: 1 up to hardness
    /// times the radius, then a smoothstep down to 0 at the radius, which is at least as wide as a
    /// texel, so that hard edges have no steps.
    double coverage(double squared_distance, double texel) const;
    /// `below` with the stroke over it where it covers so much.
    PaintLight over(const PaintLight& below, double coverage) const;

  private:
    std::vector<PaintSegment> segments_;
    PaintSegment hull_;
    double radius_, inner_, opacity_;
    Vec3f light_;
    bool erases_;
};

/// Squared distance of a point from a segment.
double squared_distance(const Vec3d& point, const PaintSegment& segment);

/// Whether some point of the box whose diagonal the segment is may be within `radius` of `box`;
/// never false where one is.
bool may_reach(const PaintSegment& segment, double radius, const Box3& box);

/// The colour, in linear light, of what `paint` lies over.
inline Vec3f painted(const PaintLight& paint, const Vec3f& below) {
    return Vec3f(paint) + (1.0f - paint.a) * below;
}

}  // namespace burl
