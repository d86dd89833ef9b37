// Fills the grid by a counting sort over its cells.
#include "atlas/mesh/point_grid.h"

#include <cmath>

namespace burl {

void PointGrid::fill(const std::vector<Vec2d>& points, const std::vector<std::uint32_t>& members) {
    side_ = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(members.size()))) + 1;
    low_ = points.front();
    Vec2d high = low_;
    for (const Vec2d& p : points) {
        low_ = glm::min(low_, p);
        high = glm::max(high, p);
    }
    for (int k = 0; k < 2; ++k)
        cells_per_unit_[k] = high[k] > low_[k] ? side_ / (high[k] - low_[k]) : 0.0;

    const auto cell_of = [&](std::uint32_t member) {
        return row(points[member].y) * side_ + column(points[member].x);
    };
    begin_.assign(std::size_t{side_} * side_, 0);
    for (const std::uint32_t member : members) ++begin_[cell_of(member)];
    std::uint32_t sum = 0;
    for (std::uint32_t& begin : begin_) {
        const std::uint32_t count = begin;
        begin = sum;
        sum += count;
    }
    end_ = begin_;
    members_.resize(members.size());
    for (const std::uint32_t member : members) members_[end_[cell_of(member)]++] = member;
}

}  // namespace burl
