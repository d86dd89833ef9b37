#include "app/image/png_filter.h"

#include <algorithm>
#include <limits>

namespace burl {
namespace {

/// The number of bytes that are filtered at a time: loops of a constant length become vector code
/// at the compiler's -O2, too.
constexpr std::size_t filter_block = 64;

/// Stores how a block differs from what `predict` makes of each byte's left, upper and upper left
/// neighbour.
template <class Predict>
void filter_bytes(const std::uint8_t* __restrict row, const std::uint8_t* __restrict above,
                  std::size_t pixel, std::uint8_t* __restrict out, const Predict& predict) {
    for (std::size_t k = 0; k < filter_block; ++k)
        out[k] = std::uint8_t(row[k + pixel] - predict(row[k], above[k + pixel], above[k]));
}

/// The neighbour nearest to left + up - corner; of equal ones the left, then the upper. Differences
/// fit 16 bits.
std::int16_t paeth_neighbour(std::int16_t left, std::int16_t up, std::int16_t corner) {
    const auto size = [](std::int16_t x) { return std::int16_t(x < 0 ? -x : x); };
    const auto dx = std::int16_t(up - corner), dy = std::int16_t(left - corner);
    const std::int16_t to_left = size(dx), to_up = size(dy);
    const std::int16_t to_corner = size(std::int16_t(dx + dy));
    const std::int16_t nearer = to_up < to_left ? up : left;
    return to_corner < std::min(to_left, to_up) ? corner : nearer;
}

std::uint32_t sum_of_block(const std::uint8_t* differences) {
    std::uint32_t sum = 0;
    for (std::size_t k = 0; k < filter_block; ++k)
        sum += std::min<std::uint8_t>(differences[k], std::uint8_t(-differences[k]));
    return sum;
}

}  // namespace

RowFilter::RowFilter(std::size_t stride, std::size_t pixel)
    : stride_(stride),
      pixel_(pixel),
      above_(pixel + stride + filter_block),
      row_(above_),
      filtered_(stride + filter_block),
      tried_(filtered_) {}

void RowFilter::add(PngFilter filter, std::vector<std::uint8_t>& out) {
    PngFilter used = filter;
    if (filter == PngFilter::adaptive) {
        std::size_t least = std::numeric_limits<std::size_t>::max();
        for (const PngFilter one :
             {PngFilter::sub, PngFilter::up, PngFilter::average, PngFilter::paeth}) {
            apply(one, tried_);
            const std::size_t differences = sum(tried_);
            if (differences >= least) continue;
            least = differences, used = one;
            filtered_.swap(tried_);
        }
    } else {
        apply(filter, filtered_);
    }
    out.push_back(std::uint8_t(used));
    out.insert(out.end(), filtered_.begin(), filtered_.begin() + std::ptrdiff_t(stride_));
    pass();
}

void RowFilter::apply(PngFilter filter, std::vector<std::uint8_t>& result) const {
    const auto each = [&](const auto& predict) {
        for (std::size_t i = 0; i < stride_; i += filter_block)
            filter_bytes(&row_[i], &above_[i], pixel_, &result[i], predict);
    };
    using Byte = std::uint8_t;
    if (filter == PngFilter::none) each([](Byte, Byte, Byte) { return Byte(0); });
    if (filter == PngFilter::sub) each([](Byte left, Byte, Byte) { return left; });
    if (filter == PngFilter::up) each([](Byte, Byte up, Byte) { return up; });
    if (filter == PngFilter::average)
        each([](Byte left, Byte up, Byte) { return Byte((left + up) / 2); });
    if (filter == PngFilter::paeth)
        each([](Byte left, Byte up, Byte corner) { return paeth_neighbour(left, up, corner); });
}

std::size_t RowFilter::sum(const std::vector<std::uint8_t>& differences) const {
    std::size_t sum = 0, i = 0;
    for (; i + filter_block <= stride_; i += filter_block) sum += sum_of_block(&differences[i]);
    for (; i < stride_; ++i)
        sum += std::min<std::uint8_t>(differences[i], std::uint8_t(-differences[i]));
    return sum;
}

}  // namespace burl
