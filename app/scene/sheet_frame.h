#pragma once
// Which part of a texture a view of it shows: moved and scaled about the pointer, as maps are.
#include "atlas/base/vec.h"

namespace burl {

struct SheetFrame {
    Vec2d centre{0.5};  ///< texture coordinates of the view's middle
    double zoom = 1.0;  ///< 1: the whole texture fits
    bool operator==(const SheetFrame&) const = default;
};

/// Of a view `size` pixels large, x to the right and y down with v.
double pixels_per_unit(const SheetFrame& frame, const Vec2d& size);
Vec2d uv_at(const SheetFrame& frame, const Vec2d& size, const Vec2d& pixel);
Vec2d pixel_at(const SheetFrame& frame, const Vec2d& size, const Vec2d& uv);

/// So that what is under the pointer follows it by so many pixels; some of the texture stays in
/// sight.
SheetFrame panned(SheetFrame frame, const Vec2d& size, const Vec2d& pixels);
/// Larger by a quarter a notch, between 1/2 and 256; what is under `pixel` stays there.
SheetFrame zoomed(SheetFrame frame, const Vec2d& size, const Vec2d& pixel, double notches);

}  // namespace burl
