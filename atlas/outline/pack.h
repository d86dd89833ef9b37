#pragma once
// Packing of outlines into a square texture. Every outline covers the cells of a grid that it and
// half a gutter round it touch, in one of four quarter turns, and cells belong to one outline: so
// MIP levels whose texels are no wider than a cell never mix two charts. Outlines are placed one
// after the other, the largest first, at the lowest free place; orders are tried and the one with
// the largest scale is kept, whose outlines are then moved apart (spread.h) (after Levy, Petitjean,
// Ray & Maillot, "Least squares conformal maps for automatic texture atlas generation", 2002, whose
// horizon is a bit mask here, so that holes are filled, too).
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "atlas/base/vec.h"

namespace burl {

/// An outline to pack.
struct Outline {
    std::span<const Vec2d> points;  ///< corners, in order
    double area = 0.0;              ///< area of its chart, in squared units of the points
};

/// The place of an outline in the texture.
struct PackedOutline {
    Vec2d column_x{1.0, 0.0}, column_y{0.0, 1.0}, origin{0.0};

    /// The place, in texels, of a point of the outline.
    Vec2d operator()(const Vec2d& q) const { return origin + q.x * column_x + q.y * column_y; }
};

/// All outlines in the texture.
struct PackedOutlines {
    std::vector<PackedOutline> outlines;
    double scale = 0.0;      ///< texels per unit, of all outlines alike
    std::uint32_t cell = 0;  ///< side of the grid's cells, in texels
};

/// Side, in texels, of the grid's cells for a texture of `size` texels a side: a power of two.
std::uint32_t outline_cell(std::uint32_t size);

/// Packs the outlines into size x size texels, as large as they fit; nothing if they are too many.
/// Pure and deterministic.
std::optional<PackedOutlines> pack_outlines(std::span<const Outline> outlines, std::uint32_t size);

}  // namespace burl
