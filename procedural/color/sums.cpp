// The table holds as many entries as the map's range or three times as many; beyond the table, the
// sum goes on with the ends' colours or with whole periods.
#include "procedural/color/sums.h"

#include <algorithm>
#include <cmath>

#include "procedural/color/map_filter.h"

namespace burl {

namespace {

constexpr double entries = ColorSums::entry_count;

}  // namespace

ColorSums::ColorSums(const ColorMap& map, bool thrice) : wrap_(map.wrap) {
    const MapPieces pieces(map);
    const int from = thrice ? -entry_count : 0, to = thrice ? 2 * entry_count : entry_count;
    const auto color = [&](int i) {
        return box_filtered(pieces, (i + 0.5) / entries, 1 / entries);
    };
    first_ = from;
    low_ = color(-1);
    high_ = color(entry_count);
    Vec3d sum(0.0);
    for (int i = from; i < 0; ++i) sum -= color(i);
    for (int i = from; i < to; ++i) {
        sums_.push_back(sum);
        sum += color(i);
    }
    sums_.push_back(sum);
}

Vec3d ColorSums::stored(double x) const {
    const double place = std::clamp(x - first_, 0.0, double(sums_.size() - 1));
    const std::size_t cell = std::min(std::size_t(place), sums_.size() - 2);
    return sums_[cell] + (place - double(cell)) * (sums_[cell + 1] - sums_[cell]);
}

Vec3d ColorSums::sum_to(double x) const {
    if (x >= first_ && x <= first_ + double(sums_.size() - 1)) return stored(x);
    if (wrap_ == Wrap::clamp)
        return stored(x) +
               (x < 0.0 ? (x - first_) * low_ : (x - first_ - double(sums_.size() - 1)) * high_);
    const double periods = std::floor(x / entries);
    return stored(x - periods * entries) + periods * stored(entries);
}

Vec3d ColorSums::operator()(double f, double width) const {
    const double wide = std::isfinite(width) ? std::max(width * entries, 1.0) : 1.0;
    double middle = std::isfinite(f) ? f : 0.0;
    middle = entries * (wrap_ == Wrap::repeat ? middle - std::floor(middle) : middle);
    return (sum_to(middle + 0.5 * wide) - sum_to(middle - 0.5 * wide)) / wide;
}

}  // namespace burl
