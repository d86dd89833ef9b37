#include "atlas/uv/nearest.h"

#include <algorithm>

#include "atlas/base/each_index.h"
#include "atlas/uv/claims.h"

namespace burl {

namespace {

/// Columns that a task sweeps side by side, so that it reads memory in order.
constexpr std::size_t swept_columns = 128;

/// Sets the rows of the nearest claimed texels of columns first to end - 1.
void sweep_columns(const Image<std::uint32_t>& owner, std::size_t first, std::size_t end,
                   Image<std::uint32_t>& rows) {
    const auto height = std::uint32_t(owner.height());
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::size_t x = first; x < end; ++x)
            rows(x, y) = owner(x, y) != unclaimed ? y : y > 0 ? rows(x, y - 1) : unclaimed;
    for (std::uint32_t y = height - 1; y-- > 0;)
        for (std::size_t x = first; x < end; ++x) {
            const std::uint32_t below = rows(x, y + 1), above = rows(x, y);
            if (below != unclaimed && below > y && (above == unclaimed || below - y < y - above))
                rows(x, y) = below;
        }
}

/// A column's parabola in a row's lower envelope: it is lowest from texel `from` on.
struct Parabola {
    std::int64_t column = 0, from = 0;
    std::int64_t lift = 0;  ///< square of the distance along the column

    std::int64_t at(std::int64_t x) const { return (x - column) * (x - column) + lift; }
};

/// The last texel at which parabola `a`, of a lower column, is not above `b`; rounded down.
std::int64_t last_of(const Parabola& a, const Parabola& b) {
    const std::int64_t rise = b.column * b.column - a.column * a.column + b.lift - a.lift;
    const std::int64_t run = 2 * (b.column - a.column);
    return rise >= 0 ? rise / run : -((-rise + run - 1) / run);
}

}  // namespace

NearestClaims::NearestClaims(const Image<std::uint32_t>& owner)
    : rows_(owner.width(), owner.height()) {
    for_each_index((owner.width() + swept_columns - 1) / swept_columns,
                   [&](std::size_t i) {
                       sweep_columns(owner, i * swept_columns,
                                     std::min((i + 1) * swept_columns, owner.width()), rows_);
                   },
                   1);
}

void NearestClaims::find(std::uint32_t y, std::vector<Place>& places) const {
    places.clear();
    const auto width = std::int64_t(rows_.width());
    std::vector<Parabola> envelope;
    for (std::int64_t x = 0; x < width; ++x) {
        const std::uint32_t row = rows_(std::size_t(x), y);
        if (row == unclaimed) continue;
        const std::int64_t away = std::int64_t(row) - std::int64_t(y);
        Parabola next{x, 0, away * away};
        while (!envelope.empty() &&
               envelope.back().at(envelope.back().from) > next.at(envelope.back().from))
            envelope.pop_back();
        if (!envelope.empty()) next.from = last_of(envelope.back(), next) + 1;
        if (next.from < width) envelope.push_back(next);
    }
    if (envelope.empty()) return;
    places.resize(std::size_t(width));
    for (std::int64_t x = width; x-- > 0;) {
        const auto column = std::size_t(envelope.back().column);
        places[std::size_t(x)] = {std::uint32_t(column), rows_(column, y)};
        if (x == envelope.back().from && envelope.size() > 1) envelope.pop_back();
    }
}

}  // namespace burl
