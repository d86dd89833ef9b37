#include "procedural/cache/span_line_cache.h"

#include <limits>

namespace burl {

std::size_t SpanLineCache::bytes_wanted() const {
    if (!solid_->wholes.empty()) return std::numeric_limits<std::size_t>::max();
    return numbers() * (6 * sizeof(double) + sizeof(std::uint32_t));
}

void SpanLineCache::allot() {
    if (allotted()) return;
    for (CacheArray<double>& array : start_) array = CacheArray<double>(numbers());
    for (CacheArray<double>& array : step_) array = CacheArray<double>(numbers());
    counts_ = CacheArray<std::uint32_t>(numbers());
    longest_ = std::vector<std::uint32_t>(solid_->size);
    for (std::size_t y = 0; y < solid_->size; ++y)
        for (const Span& span : solid_->row(y)) longest_[y] = std::max(longest_[y], span.count);
    known_ = std::vector<std::uint8_t>(solid_->size);
}

void SpanLineCache::free() {
    if (allotted()) *this = SpanLineCache(*solid_);
}

SpanLines SpanLineCache::lines_from(std::size_t number) const {
    SpanLines lines;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        lines.start[axis] = start_[axis].data() + number;
        lines.step[axis] = step_[axis].data() + number;
    }
    lines.counts = counts_.data() + number;
    return lines;
}

/// Fills the lines of a row's spans, with the bits that PieceReader gives
/// (procedural/fill/pieces.h).
void SpanLineCache::fill_row(std::size_t y, const std::vector<TexelMap>& maps) {
    std::size_t i = begin(y);
    const auto add = [&](const Vec3d& start, const Vec3d& step, std::uint32_t count) {
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            start_[axis].data()[i] = start[axis];
            step_[axis].data()[i] = step[axis];
        }
        counts_.data()[i++] = count;
    };
    for (const Span& span : solid_->row(y)) {
        const TexelMap& texel = maps[span.map];
        add(texel(span.x, std::int64_t(y)), texel.step_x, span.count);
    }
    for (std::size_t k = 0; k < span_padding; ++k) add(Vec3d(0.0), Vec3d(0.0), 0);
    known_[y] = 1;
}

}  // namespace burl
