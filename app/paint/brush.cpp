#include "app/paint/brush.h"

#include <algorithm>
#include <cmath>

#include "procedural/color/srgb.h"

namespace burl {

namespace {

std::vector<PaintSegment> segments_of(const std::vector<Vec3d>& points) {
    std::vector<PaintSegment> segments;
    if (points.size() == 1) segments.push_back({points[0], points[0]});
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        segments.push_back({points[i], points[i + 1]});
    return segments;
}

PaintSegment hull_of(std::span<const PaintSegment> segments) {
    PaintSegment hull = segments.empty() ? PaintSegment{} : segments[0];
    for (const PaintSegment& s : segments) {
        const Vec3d low = glm::min(s.from, s.to), high = glm::max(s.from, s.to);
        hull = {glm::min(low, glm::min(hull.from, hull.to)),
                glm::max(high, glm::max(hull.from, hull.to))};
    }
    return hull;
}

}  // namespace

PaintBrush::PaintBrush(const PaintStroke& stroke)
    : segments_(segments_of(stroke.points)),
      hull_(hull_of(segments_)),
      radius_(stroke.radius),
      inner_(stroke.hardness * stroke.radius),
      opacity_(stroke.opacity),
      light_(linear_light(stroke.color)),
      erases_(stroke.mode == PaintMode::erase) {}

double PaintBrush::coverage(double squared_distance, double texel) const {
    if (!(squared_distance < radius_ * radius_)) return 0.0;
    const double distance = std::sqrt(squared_distance);
    const double inner = std::clamp(radius_ - texel, 0.0, inner_);
    if (distance <= inner) return 1.0;
    const double t = std::max(0.0, (radius_ - distance) / (radius_ - inner));
    return t * t * (3.0 - 2.0 * t);
}

Dual PaintBrush::coverage(const Vec3d& point, std::span<const PaintSegment> near,
                          double texel) const {
    Vec3d apart = apart_from(point, near[0]);
    for (const PaintSegment& segment : near.subspan(1))
        if (const Vec3d other = apart_from(point, segment);
            glm::dot(other, other) < glm::dot(apart, apart))
            apart = other;
    const double squared = glm::dot(apart, apart), inner = std::clamp(radius_ - texel, 0.0, inner_);
    const double value = coverage(squared, texel);
    if (value <= 0.0 || value >= 1.0) return value;
    const double distance = std::sqrt(squared), width = radius_ - inner;
    const double t = (radius_ - distance) / width;
    return {value, -6.0 * t * (1.0 - t) / (width * distance) * apart};
}

Dual PaintBrush::over(const Dual& below, const Dual& coverage) const {
    const Dual alpha = Dual(opacity_) * coverage;
    const Dual kept = (Dual(1.0) - alpha) * below;
    return erases_ ? kept : kept + alpha;
}

PaintLight PaintBrush::over(const PaintLight& below, double coverage) const {
    const auto alpha = float(opacity_ * coverage);
    const PaintLight kept = (1.0f - alpha) * below;
    return erases_ ? kept : kept + PaintLight(alpha * light_, alpha);
}

Vec3d apart_from(const Vec3d& point, const PaintSegment& segment) {
    const Vec3d along = segment.to - segment.from, offset = point - segment.from;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(offset, along) / length2, 0.0, 1.0) : 0.0;
    return offset - t * along;
}

double squared_distance(const Vec3d& point, const PaintSegment& segment) {
    const Vec3d apart = apart_from(point, segment);
    return glm::dot(apart, apart);
}

bool may_reach(const PaintSegment& segment, double radius, const Box3& box) {
    constexpr double margin = 1e-9;  // many times the rounding error of a distance
    double squared = 0.0, size = radius;
    for (int k = 0; k < 3; ++k) {
        const double low = std::min(segment.from[k], segment.to[k]),
                     high = std::max(segment.from[k], segment.to[k]);
        const double gap = std::max({0.0, box.low[k] - high, low - box.high[k]});
        squared += gap * gap;
        size = std::max({size, std::abs(low), std::abs(high)});
    }
    const double reach = radius + margin * size;
    return squared <= reach * reach;
}

}  // namespace burl
