#include "atlas/blocks/pack_blocks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace burl {

namespace {

constexpr double dearer_per_doubling = 0.03;  // relative cost per doubling of the aspect
constexpr int sizes = 15;                     // log2 of sides: 1 to 16384 texels

/// The free rectangles of a texture of fixed width, by the logarithms of their sides.
class Shelves {
  public:
    explicit Shelves(int log_width) : log_width_(log_width) {}

    void place(PackedBlock& block) {
        auto [w, h] = smallest_free(block);
        if (w < 0) {
            std::tie(w, h) = std::pair(log_width_, block.log_height);
            free_at(w, h).push_back({0, height_});
            height_ += 1u << h;
        }
        Corner at = free_at(w, h).back();
        free_at(w, h).pop_back();
        for (; h > block.log_height; --h)
            free_at(w, h - 1).push_back({at.x, at.y + (1u << (h - 1))});
        for (; w > block.log_width; --w)
            free_at(w - 1, h).push_back({at.x + (1u << (w - 1)), at.y});
        block.x = at.x;
        block.y = at.y;
    }
    std::uint32_t height() const { return height_; }

  private:
    struct Corner {
        std::uint32_t x = 0, y = 0;
    };
    std::vector<Corner>& free_at(int w, int h) { return free_[std::size_t(w * sizes + h)]; }

    /// Logarithms of the sides of the smallest free rectangle that holds the block, or -1.
    std::pair<int, int> smallest_free(const PackedBlock& block) {
        std::pair<int, int> best{-1, -1};
        for (int w = block.log_width; w <= log_width_; ++w)
            for (int h = block.log_height; h < sizes; ++h)
                if (!free_at(w, h).empty() && (best.first < 0 || w + h < best.first + best.second))
                    best = {w, h};
        return best;
    }

    int log_width_;
    std::uint32_t height_ = 0;
    std::array<std::vector<Corner>, sizes * sizes> free_;
};

std::uint32_t pack_in(std::span<PackedBlock> blocks, std::span<const std::uint32_t> order,
                      int log_width) {
    Shelves shelves(log_width);
    for (const std::uint32_t i : order) shelves.place(blocks[i]);
    return shelves.height();
}

}  // namespace

PackedSize pack_blocks(std::span<PackedBlock> blocks, std::uint32_t most_width) {
    if (blocks.empty()) return {};
    std::vector<std::uint32_t> order(blocks.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(blocks[a].log_height, blocks[a].log_width) >
               std::pair(blocks[b].log_height, blocks[b].log_width);
    });
    const int widest = std::ranges::max(blocks, {}, &PackedBlock::log_width).log_width;
    const int most = std::max(widest, int(std::bit_width(most_width)) - 1);
    int best = most;
    double least = std::numeric_limits<double>::infinity();
    for (int log_width = most; log_width >= widest; --log_width) {
        const std::uint32_t width = 1u << log_width, height = pack_in(blocks, order, log_width);
        if (height > (1u << (sizes - 1))) break;
        const double aspect = std::abs(std::log2(double(width) / height)),
                     cost = double(width) * height * (1.0 + dearer_per_doubling * aspect);
        if (cost < least) least = cost, best = log_width;
    }
    return {1u << best, pack_in(blocks, order, best)};
}

}  // namespace burl
