#include "atlas/solid/texel_set.h"

#include "atlas/base/mip_chain.h"

namespace burl {

namespace {

/// The word with all bits set of every cell of `side` bits that has a bit set.
std::uint32_t filled_cells(std::uint32_t word, std::uint32_t side) {
    for (std::uint32_t k = 1; k < side; k *= 2) word |= word >> k;
    std::uint32_t first_bits = 0;
    for (std::uint32_t at = 0; at < tile_side; at += side) first_bits |= 1U << at;
    word &= first_bits;
    for (std::uint32_t k = 1; k < side; k *= 2) word |= word << k;
    return word;
}

}  // namespace

void TexelSet::insert(const TexelRange& xs, std::uint32_t y) {
    for (std::uint32_t x = xs.first; x < xs.last;) {
        const std::uint32_t low = x % tile_side, count = std::min(tile_side - low, xs.last - x);
        bits_[std::size_t{y} * words_ + x / tile_side] |= ~0U >> (tile_side - count) << low;
        x += count;
    }
}

TexelSet& TexelSet::operator|=(const TexelSet& other) {
    for (std::size_t i = 0; i < bits_.size(); ++i) bits_[i] |= other.bits_[i];
    return *this;
}

std::uint64_t TexelSet::count() const {
    std::uint64_t count = 0;
    for (const std::uint32_t word : bits_) count += std::uint64_t(std::popcount(word));
    return count;
}

std::uint64_t TexelSet::count_tiles() const {
    std::uint64_t count = 0;
    for (std::uint32_t y = 0; y < size_; y += tile_side)
        for (std::uint32_t tile = 0; tile < words_; ++tile) {
            std::uint32_t any = 0;
            for (std::uint32_t j = y; j < std::min(y + tile_side, size_); ++j) any |= row(j)[tile];
            count += any != 0;
        }
    return count;
}

TexelSet TexelSet::whole_cells(std::uint32_t side) const {
    TexelSet cells(size_);
    const std::uint32_t rest = size_ % tile_side;
    for (std::uint32_t y = 0; y < size_; y += side)
        for (std::uint32_t tile = 0; tile < words_; ++tile) {
            std::uint32_t any = 0;
            const std::uint32_t end = std::min(y + side, size_);
            for (std::uint32_t j = y; j < end; ++j) any |= row(j)[tile];
            any = filled_cells(any, side);
            if (rest > 0 && tile + 1 == words_) any &= ~0U >> (tile_side - rest);
            for (std::uint32_t j = y; j < end; ++j)
                cells.bits_[std::size_t{j} * words_ + tile] = any;
        }
    return cells;
}

TexelSet TexelSet::beneath(std::uint32_t size) const {
    TexelSet finer(size);
    const std::vector<MipTaps> taps = mip_taps(size);
    for (std::uint32_t y = 0; y < size_; ++y)
        for_each_run(y, {0, size_}, [&](std::uint32_t first, std::uint32_t last) {
            const MipTaps& end = taps[last - 1];
            const TexelRange xs{std::uint32_t(taps[first].first),
                                std::uint32_t(end.first + end.count)};
            for (std::size_t j = 0; j < taps[y].count; ++j)
                finer.insert(xs, std::uint32_t(taps[y].first + j));
        });
    return finer;
}

SolidAtlas cut_to(const SolidAtlas& solid, const TexelSet& wanted) {
    SolidAtlas part;
    part.size = solid.size;
    part.maps = solid.maps;
    part.turned = solid.turned;
    part.row_begin.reserve(solid.row_begin.size());
    for (std::uint32_t y = 0; y < solid.size; ++y) {
        part.row_begin.push_back(part.spans.size());
        for (const Span& span : solid.row(y)) {
            const WholeSpan whole = solid.whole(span);
            wanted.for_each_run(y, {span.x, span.x + span.count},
                                [&](std::uint32_t first, std::uint32_t last) {
                                    part.spans.push_back({first, last - first, span.map});
                                    part.wholes.push_back(whole);
                                });
        }
    }
    part.row_begin.push_back(part.spans.size());
    return part;
}

std::uint64_t texel_count(const SolidAtlas& solid) {
    std::uint64_t count = 0;
    for (const Span& span : solid.spans) count += span.count;
    return count;
}

}  // namespace burl
