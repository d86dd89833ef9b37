#pragma once
// The lattice cells that a scan line passes through, texel by texel: the line drawing of Bresenham
// and the grid traversal of Amanatides & Woo (1987), by which "Bresenham Noise" knows when its
// differences must be computed anew. Planes are counted in whole numbers, and a cell follows from
// the planes between which its texels lie: a coordinate that rounding moved across a plane can
// neither give a whole stretch the wrong cell nor skip one. The stretches depend on the line alone,
// not on the texel where a walk begins.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "procedural/batch/texel_batch.h"

namespace burl {

/// Texels first to last - 1 of a line, all in one cell. `last` may lie beyond the line's end.
struct CellStretch {
    std::int64_t first = 0, last = 0;
    std::array<std::int64_t, 3> cell{};
};

/// The walk of one coordinate of a line, start + j * step at texel j >= 0, from cell to cell.
class AxisWalk {
  public:
    AxisWalk() = default;
    AxisWalk(double start, double step) : start_(start), step_(step) {
        // A step too small to change a double other than 0 crosses no plane.
        if (std::abs(step) < std::numeric_limits<double>::min()) step_ = 0.0;
        direction_ = step_ < 0.0 ? -1 : 1;
    }

    /// Sets the cell of a texel, and the range of texels in which the line stays in it.
    void locate(std::int64_t texel) {
        cell_ = std::int64_t(std::floor(start_ + double(texel) * step_));
        if (step_ == 0.0) return;
        if (entry(cell_) > texel)
            cell_ -= direction_;
        else if (entry(cell_ + direction_) <= texel)
            cell_ += direction_;
        first_ = std::min(entry(cell_), texel);
        last_ = std::max(entry(cell_ + direction_), texel + 1);
    }

    /// Advances to the cell of texel last().
    void advance() {
        first_ = last_;
        cell_ += direction_;
        last_ = entry(cell_ + direction_);
        if (last_ <= first_) locate(first_);
    }

    std::int64_t cell() const { return cell_; }
    std::int64_t first() const { return first_; }
    std::int64_t last() const { return last_; }

  private:
    static constexpr std::int64_t never = std::int64_t(1) << 62;

    /// The first texel that lies in the cell or beyond it. A plane belongs to the cell above it.
    std::int64_t entry(std::int64_t cell) const {
        const double plane = double(direction_ > 0 ? cell : cell + 1);
        const double at = std::min((plane - start_) / step_, double(never));
        if (at < 0.0) return 0;
        const auto whole = std::int64_t(at);
        return whole + (direction_ < 0 || double(whole) < at);
    }

    double start_ = 0.0, step_ = 0.0;
    std::int64_t direction_ = 1, cell_ = 0, first_ = 0, last_ = never;
};

/// The stretches of a line in lattice coordinates, from the one that holds texel line.first on. All
/// coordinates must be below lattice_limit.
class CellWalk {
  public:
    CellWalk() = default;
    explicit CellWalk(const LatticeLine& line) {
        for (int axis = 0; axis < 3; ++axis) {
            axes_[std::size_t(axis)] = AxisWalk(line.start[axis], line.step[axis]);
            axes_[std::size_t(axis)].locate(std::int64_t(line.first));
        }
        gather();
    }

    const CellStretch& stretch() const { return stretch_; }

    void advance() {
        const std::int64_t at = stretch_.last;
        for (AxisWalk& axis : axes_)
            if (axis.last() == at) axis.advance();
        gather();
    }

  private:
    void gather() {
        stretch_.first = std::max({axes_[0].first(), axes_[1].first(), axes_[2].first()});
        stretch_.last = std::min({axes_[0].last(), axes_[1].last(), axes_[2].last()});
        for (std::size_t axis = 0; axis < 3; ++axis) stretch_.cell[axis] = axes_[axis].cell();
    }

    std::array<AxisWalk, 3> axes_;
    CellStretch stretch_;
};

}  // namespace burl
