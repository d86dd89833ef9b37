#include "app/scene/sheet_frame.h"

#include <algorithm>
#include <cmath>

namespace burl {

namespace {

// The share of the shorter side that the whole texture takes at zoom 1.
constexpr double filled = 0.96;

SheetFrame within_sight(SheetFrame frame) {
    frame.centre = glm::clamp(frame.centre, Vec2d(0.0), Vec2d(1.0));
    return frame;
}

}  // namespace

double pixels_per_unit(const SheetFrame& frame, const Vec2d& size) {
    return filled * frame.zoom * std::max(1.0, std::min(size.x, size.y));
}

Vec2d uv_at(const SheetFrame& frame, const Vec2d& size, const Vec2d& pixel) {
    return frame.centre + (pixel - 0.5 * size) / pixels_per_unit(frame, size);
}

Vec2d pixel_at(const SheetFrame& frame, const Vec2d& size, const Vec2d& uv) {
    return 0.5 * size + (uv - frame.centre) * pixels_per_unit(frame, size);
}

SheetFrame panned(SheetFrame frame, const Vec2d& size, const Vec2d& pixels) {
    frame.centre -= pixels / pixels_per_unit(frame, size);
    return within_sight(frame);
}

SheetFrame zoomed(SheetFrame frame, const Vec2d& size, const Vec2d& pixel, double notches) {
    const Vec2d fixed = uv_at(frame, size, pixel);
    frame.zoom = std::clamp(frame.zoom * std::pow(1.25, notches), 0.5, 256.0);
    frame.centre += fixed - uv_at(frame, size, pixel);
    return within_sight(frame);
}

}  // namespace burl
