#pragma once
// The visible part of a texture in a two-dimensional view, panned and zoomed about the pointer.
#include "atlas/base/vec.h"

namespace burl {

struct SheetFrame {
    Vec2d centre{0.5};  ///< the texture coordinates at the view's centre
    double zoom = 1.0;  ///< 1: the whole texture fits
    bool operator==(const SheetFrame&) const = default;
};

/// The length in pixels of a unit of texture coordinates, in a view of `size` pixels.
double pixels_per_unit(const SheetFrame& frame, const Vec2d& size);
/// The texture coordinates at a pixel of a view of `size` pixels; x points to the right, y down
/// with v.
Vec2d uv_at(const SheetFrame& frame, const Vec2d& size, const Vec2d& pixel);
/// The pixel of a view of `size` pixels that shows the texture coordinates.
Vec2d pixel_at(const SheetFrame& frame, const Vec2d& size, const Vec2d& uv);

/// The frame moved by so many pixels with the pointer; its centre stays within the texture.
SheetFrame panned(SheetFrame frame, const Vec2d& size, const Vec2d& pixels);
/// The frame with its zoom multiplied by 1.25^notches, within 1/2 and 256; the texture coordinates
/// at `pixel` stay there.
SheetFrame zoomed(SheetFrame frame, const Vec2d& size, const Vec2d& pixel, double notches);

}  // namespace burl
