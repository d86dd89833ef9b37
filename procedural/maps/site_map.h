#pragma once
// Lattice maps (field/lattice_map.h) in the form that software OpenGL reads fastest: in the order
// in which it draws texels, squares of 64 x 64 row by row and in them blocks of 4 x 4, so that
// memory is read from front to back, and with one hash instead of a cell's three numbers.
#include <optional>

#include "atlas/solid/solid_atlas.h"
#include "procedural/field/lattice_map.h"
#include "procedural/fixed/index.h"

namespace burl {

/// The order of texels: a texel's number in a map that is `columns` squares wide.
struct SiteOrder {
    static constexpr std::uint32_t square = 64, square_texels = square * square;
    std::uint32_t columns = 0, rows = 0;  ///< squares that cover the area

    SiteOrder(std::uint32_t width, std::uint32_t height)
        : columns((width + square - 1) / square), rows((height + square - 1) / square) {}
    std::size_t texels() const { return std::size_t(columns) * rows * square_texels; }
    std::size_t operator()(std::uint32_t x, std::uint32_t y) const {
        const std::size_t at = std::size_t(y / square) * columns + x / square;
        return at << 12 | (y & 60) << 6 | (x & 60) << 2 | (y & 3) << 2 | (x & 3);
    }
};

/// The site of every texel: its cell's hash without a seed (numbers/lattice_hash.h) and its place
/// in units of 2^-32 cells; 0 where no span shows anything, and beyond the area. The area is at
/// most a square high.
std::vector<MapTexel> fill_site_map(const SolidAtlas& solid, std::span<const TexelMap> maps,
                                    const LatticeStreamKey& stream, const TexelArea& area,
                                    int threads);

/// fixed_base of the quadric per texel, no_base where no span shows anything and beyond the area;
/// none where fixed point would not hold it.
std::optional<std::vector<std::uint32_t>> fill_base_map(const SolidAtlas& solid,
                                                        std::span<const TexelMap> maps,
                                                        const Quadric& quadric,
                                                        const FixedIndex& field,
                                                        const TexelArea& area, int threads);

}  // namespace burl
