#pragma once
// Sets of texels of one square texture or level, a bit each, in tiles of 32 x 32: the texels that a
// view looks up, and so those that must be worked out for it (virtual texturing: Barrett, "Sparse
// Virtual Textures", 2008; Mayer, "Virtual Texturing", 2010).
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "atlas/solid/solid_atlas.h"

namespace burl {

inline constexpr std::uint32_t tile_side = 32;  ///< side of a tile in texels

/// Texels first to last - 1 of a row; empty where first == last.
struct TexelRange {
    std::uint32_t first = 0, last = 0;
};

/// A set of texels as a bit mask.
class TexelSet {
  public:
    /// The empty set for a texture of `size` x `size` texels.
    explicit TexelSet(std::uint32_t size = 0)
        : size_(size),
          words_((size + tile_side - 1) / tile_side),
          bits_(std::size_t{size} * words_) {}

    std::uint32_t size() const { return size_; }
    bool contains(std::uint32_t x, std::uint32_t y) const {
        return (row(y)[x / tile_side] >> x % tile_side & 1U) != 0;
    }
    void insert(std::uint32_t x, std::uint32_t y) {
        bits_[std::size_t{y} * words_ + x / tile_side] |= 1U << x % tile_side;
    }
    /// Adds the texels `xs` of row y, which must lie within the texture; `xs` may be empty.
    void insert(const TexelRange& xs, std::uint32_t y);
    /// Adds the texels of `other`, a set for a texture of the same size.
    TexelSet& operator|=(const TexelSet& other);
    bool operator==(const TexelSet&) const = default;

    /// Number of texels in the set.
    std::uint64_t count() const;
    /// Number of tiles with a texel in the set; tiles at the far borders may be smaller.
    std::uint64_t count_tiles() const;

    /// All texels of the cells of side x side texels (a power of two up to tile_side) that hold a
    /// texel of the set.
    TexelSet whole_cells(std::uint32_t side) const;
    /// The texels of a texture of `size` texels a side that the set's texels are means of, where
    /// halve() (mip_chain.h) makes this set's level of that texture.
    TexelSet beneath(std::uint32_t size) const;

    /// Calls visit(first, last) for the runs first to last - 1 of row y within `xs`, in order.
    template <class Visit>
    void for_each_run(std::uint32_t y, const TexelRange& xs, const Visit& visit) const {
        for (std::uint32_t x = find(y, xs.first, xs.last, true); x < xs.last;) {
            const std::uint32_t end = find(y, x, xs.last, false);
            visit(x, end);
            x = find(y, end, xs.last, true);
        }
    }

  private:
    const std::uint32_t* row(std::uint32_t y) const {
        return bits_.data() + std::size_t{y} * words_;
    }
    /// The first texel in [x, last) of row y whose membership is `in`; `last` where there is none.
    std::uint32_t find(std::uint32_t y, std::uint32_t x, std::uint32_t last, bool in) const {
        while (x < last) {
            const std::uint32_t word = row(y)[x / tile_side];
            const std::uint32_t rest = (in ? word : ~word) >> x % tile_side;
            if (rest != 0) return std::min(x + std::uint32_t(std::countr_zero(rest)), last);
            x += tile_side - x % tile_side;
        }
        return last;
    }

    std::uint32_t size_, words_;  ///< texels a side, and words of 32 texels a row
    std::vector<std::uint32_t> bits_;
};

/// The atlas cut to `wanted`, a set for a texture of its size. A texel gets the same bytes in the
/// part as in the whole atlas: its coordinates are still worked out from the uncut span's start,
/// and what depends on a span's length depends on the uncut span's, also where an atlas is cut
/// twice.
SolidAtlas cut_to(const SolidAtlas& solid, const TexelSet& wanted);

/// Number of texels of all spans.
std::uint64_t texel_count(const SolidAtlas& solid);

}  // namespace burl
