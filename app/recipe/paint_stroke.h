#pragma once
// Brush strokes in solid space: paint over the procedural texture, as data of the recipe. After
// Carr & Hart's meshed atlases, where every point of the surface has texels of its own and painting
// needs no unwrapping.
#include <span>
#include <vector>

#include "atlas/base/enum_names.h"
#include "atlas/base/image.h"
#include "atlas/base/vec.h"

namespace burl {

enum class PaintMode {
    paint,  ///< lays colour over the texture and earlier strokes
    erase   ///< removes paint, down to the texture
};
template <>
inline constexpr auto enum_names<PaintMode> = enum_words("paint", "erase");

/// A ball swept along a polyline; it covers the surface that it touches.
struct PaintStroke {
    std::vector<Vec3d> points{};  ///< the polyline in solid space, before scale and rotation
    double radius = 0.05;         ///< the ball's radius in solid units, > 0
    double hardness = 0.5;        ///< 0..1: the share of the radius with full coverage
    double opacity = 1.0;         ///< the opacity at full coverage, 0..1
    Rgb8 color{0, 0, 0};          ///< sRGB
    PaintMode mode = PaintMode::paint;
    int layer = 0;  ///< 0: colour over the texture; else the mask that nodes `paint` read
    bool operator==(const PaintStroke&) const = default;
};

/// The largest number of a layer.
inline constexpr int most_paint_layers = 99;

/// The strokes of one layer, in their order.
std::vector<PaintStroke> strokes_of(std::span<const PaintStroke> strokes, int layer);

/// The strokes of all masks, in their order.
std::vector<PaintStroke> mask_strokes(std::span<const PaintStroke> strokes);

/// Whether a stroke lays colour over the texture, or takes it away.
bool has_color_paint(std::span<const PaintStroke> strokes);

}  // namespace burl
