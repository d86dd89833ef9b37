#include "atlas/blocks/compress_blocks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "atlas/base/error.h"

namespace burl {

namespace {

constexpr std::size_t most_compared = 64;  ///< latest blocks of a similar mean to compare with

template <class T>
constexpr double full_scale() {
    return std::is_floating_point_v<T> ? 1.0 : double(std::numeric_limits<T>::max());
}

template <class T>
std::array<double, 3> channels(const Rgb<T>& p) {
    constexpr double scale = full_scale<T>();
    return {double(p.r) / scale, double(p.g) / scale, double(p.b) / scale};
}

/// A block's sides and its mean colour, quantised.
using BlockKey = std::array<std::int64_t, 5>;

struct BlockKeyHash {
    std::size_t operator()(const BlockKey& key) const {
        std::uint64_t hash = 0;
        for (const std::int64_t k : key)
            hash = (hash ^ std::uint64_t(k)) * 0x9e3779b97f4a7c15u + (hash >> 29);
        return hash;
    }
};

/// Finds, for each block, an earlier block that looks alike.
template <class Pixel>
class Alike {
  public:
    Alike(const Atlas& atlas, const Image<Pixel>& image, double most_error)
        : atlas_(atlas), image_(image), most_error_(most_error) {}

    /// Number of the first block that looks like block i; i itself if there is none.
    std::uint32_t find(std::uint32_t i) {
        const BlockKey key = key_of(atlas_.blocks[i]);
        const int reach = most_error_ > 0.0 ? 1 : 0;
        for (int r = -reach; r <= reach; ++r)
            for (int g = -reach; g <= reach; ++g)
                for (int b = -reach; b <= reach; ++b) {
                    const auto found =
                        seen_.find({key[0], key[1], key[2] + r, key[3] + g, key[4] + b});
                    if (found == seen_.end()) continue;
                    if (const std::int64_t j = find_in(found->second, i); j >= 0)
                        return std::uint32_t(j);
                }
        seen_[key].push_back(i);
        return i;
    }
    double largest_error() const { return largest_error_; }

  private:
    BlockKey key_of(const Block& block) const;
    /// Largest difference of a channel; infinite when it exceeds most_error_.
    double difference(const Block& a, const Block& b) const;
    std::int64_t find_in(const std::vector<std::uint32_t>& candidates, std::uint32_t i) {
        const std::size_t from = candidates.size() - std::min(candidates.size(), most_compared);
        for (std::size_t k = from; k < candidates.size(); ++k) {
            const double off = difference(atlas_.blocks[candidates[k]], atlas_.blocks[i]);
            if (off > most_error_) continue;
            largest_error_ = std::max(largest_error_, off);
            return candidates[k];
        }
        return -1;
    }

    const Atlas& atlas_;
    const Image<Pixel>& image_;
    double most_error_;
    double largest_error_ = 0.0;
    std::unordered_map<BlockKey, std::vector<std::uint32_t>, BlockKeyHash> seen_;
};

template <class Pixel>
BlockKey Alike<Pixel>::key_of(const Block& block) const {
    std::array<double, 3> sums{};
    for (std::uint32_t y = block.y; y < block.y + block.height; ++y)
        for (const Pixel& p : image_.row(y).subspan(block.x, block.width))
            for (std::size_t k = 0; k < 3; ++k) sums[k] += channels(p)[k];
    // Mean colours of alike blocks differ by at most the error plus rounding, so the step is a
    // little wider.
    const double width = std::max(1.001 * most_error_, 0x1p-20);
    BlockKey key{block.width, block.height};
    const double texels = double(block.width) * block.height;
    for (std::size_t k = 0; k < 3; ++k)
        key[k + 2] = std::int64_t(std::floor(std::clamp(sums[k] / texels / width, -1e15, 1e15)));
    return key;
}

template <class Pixel>
double Alike<Pixel>::difference(const Block& a, const Block& b) const {
    double largest = 0.0;
    for (std::uint32_t y = 0; y < a.height; ++y) {
        const auto row_a = image_.row(a.y + y).subspan(a.x, a.width),
                   row_b = image_.row(b.y + y).subspan(b.x, b.width);
        for (std::size_t x = 0; x < row_a.size(); ++x) {
            const auto p = channels(row_a[x]), q = channels(row_b[x]);
            for (std::size_t k = 0; k < 3; ++k) largest = std::max(largest, std::abs(p[k] - q[k]));
        }
        if (largest > most_error_) return std::numeric_limits<double>::infinity();
    }
    return largest;
}

void move_block(Atlas& atlas, Block& block, std::uint32_t x, std::uint32_t y) {
    const Vec2d move{double(x) - block.x, double(y) - block.y};
    for (const std::int32_t t : {block.lower, block.upper}) {
        if (t < 0) continue;
        for (Vec2d& corner : atlas.corners[std::size_t(t)]) corner += move;
    }
    block.x = x;
    block.y = y;
}

template <class Pixel>
void copy_texels(const Image<Pixel>& from, const Block& block, Image<Pixel>& to,
                 const PackedBlock& at) {
    for (std::uint32_t y = 0; y < block.height; ++y)
        std::ranges::copy(from.row(block.y + y).subspan(block.x, block.width),
                          to.row(at.y + y).begin() + at.x);
}

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

template <class Pixel>
Compressed<Pixel> compress_blocks(Atlas atlas, const Image<Pixel>& image, double most_error) {
    if (atlas.options.kind != AtlasKind::quad)
        throw Error(ExitCode::usage,
                    fmt::format("only the quad atlas has blocks that can share a place, this one "
                                "is {}; use --atlas quad with --compress",
                                to_string(atlas.options.kind)));
    Alike<Pixel> alike(atlas, image, most_error);
    std::vector<std::uint32_t> like(atlas.blocks.size()), place(atlas.blocks.size());
    std::vector<PackedBlock> packed;
    CompressNotes notes;
    for (std::uint32_t i = 0; i < like.size(); ++i) {
        const Block& block = atlas.blocks[i];
        like[i] = block.shares_texel ? like[i - 1] : alike.find(i);
        if (!block.shares_texel) ++notes.blocks;
        if (like[i] != i) continue;
        place[i] = static_cast<std::uint32_t>(packed.size());
        packed.push_back({std::countr_zero(block.width), std::countr_zero(block.height)});
    }
    notes.places = packed.size();
    notes.texels_before = image.width() * image.height();
    notes.largest_error = alike.largest_error();
    const PackedSize size = pack_blocks(packed, atlas.options.size);
    notes.texels_after = std::uint64_t{size.width} * size.height;
    if (notes.texels_after >= notes.texels_before) {
        notes.texels_after = notes.texels_before;
        notes.places = notes.blocks;
        notes.largest_error = 0.0;
        return {std::move(atlas), image, notes};
    }
    Image<Pixel> result(size.width, size.height);
    for (std::uint32_t i = 0; i < like.size(); ++i)
        if (like[i] == i) copy_texels(image, atlas.blocks[i], result, packed[place[i]]);
    for (std::uint32_t i = 0; i < like.size(); ++i) {
        const PackedBlock& at = packed[place[like[i]]];
        move_block(atlas, atlas.blocks[i], at.x, at.y);
    }
    atlas.width = size.width;
    atlas.height = size.height;
    return {std::move(atlas), std::move(result), notes};
}

template Compressed<Rgb8> compress_blocks(Atlas, const Image<Rgb8>&, double);
template Compressed<Rgb16> compress_blocks(Atlas, const Image<Rgb16>&, double);
template Compressed<RgbF> compress_blocks(Atlas, const Image<RgbF>&, double);

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
