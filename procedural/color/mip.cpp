// Entries of the full table are the map's means over the entries' intervals; therefore those of
// every halved table are, too.
#include "procedural/color/mip.h"

#include <algorithm>
#include <cmath>

#include "atlas/base/elementary.h"
#include "procedural/color/map_filter.h"
#include "procedural/color/table.h"

namespace burl {

ColorMip::ColorMip(const ColorMap& map) : wrap_(map.wrap) {
    const MapPieces pieces(map);
    std::vector<Vec3d> table(std::size_t(1) << finest);
    const double entry = 1.0 / double(table.size());
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = box_filtered(pieces, (double(i) + 0.5) * entry, entry);
    levels_.push_back(table);
    while (table.size() > 1) {
        for (std::size_t i = 0; i < table.size() / 2; ++i)
            table[i] = 0.5 * (table[2 * i] + table[2 * i + 1]);
        table.resize(table.size() / 2);
        levels_.push_back(table);
    }
}

Vec3d ColorMip::at_level(int level, double index) const {
    const auto& table = levels_[std::size_t(level)];
    const auto count = std::int64_t(table.size());
    const double x = index * double(count) - 0.5, cell = std::floor(x);
    const auto entry = [&](std::int64_t i) {
        i = wrap_ == Wrap::repeat ? (i + count) % count : std::clamp<std::int64_t>(i, 0, count - 1);
        return table[std::size_t(i)];
    };
    const Vec3d low = entry(std::int64_t(cell)), high = entry(std::int64_t(cell) + 1);
    return low + (x - cell) * (high - low);
}

Vec3d ColorMip::operator()(double f, double width) const {
    const double index = map_index(wrap_, f);
    const double level = binary_log(std::max(std::ldexp(width, finest), 1.0));
    if (!(level < finest)) return levels_.back()[0];
    const int i = int(level);
    const Vec3d fine = at_level(i, index);
    return fine + (level - i) * (at_level(i + 1, index) - fine);
}

}  // namespace burl
