#pragma once
// The colour map as a function on the whole line: linear pieces between breaks, the jump and the
// kink at every break, and the map's first and second antiderivative. Filters integrate the map
// exactly from these; a table of colours (Hart et al. 1999, section 3.3) only approximates the
// integral.
//
// With `repeat` the antiderivatives are those of the map less its mean and are made periodic, so
// they are as exact at f = 1e9 as at 0. With `clamp` they go on beyond the ends as polynomials.
#include <cstdint>
#include <vector>

#include "atlas/base/vec.h"
#include "procedural/color/map.h"

namespace burl {

/// A position where the map is not smooth: to its right the colour is `jump` higher and the slope
/// `kink` steeper than to its left.
struct MapBreak {
    double position = 0.0;  ///< index in [0, 1]; with `repeat` in [0, 1), repeated with period 1
    Vec3d jump{0.0}, kink{0.0};
};

class MapPieces {
  public:
    /// A linear piece of the map: c(start + x) = color + slope x + mean().
    struct Piece {
        double start = 0.0;
        Vec3d color{0.0}, slope{0.0};
        Vec3d first{0.0}, second{0.0};  ///< antiderivatives at `start`
    };
    explicit MapPieces(const ColorMap& map);

    Wrap wrap() const { return wrap_; }
    /// The breaks, ascending by position; positions without jump and kink are left out.
    const std::vector<MapBreak>& breaks() const { return breaks_; }
    /// The pieces, ascending by start; the first extends to the left, the last to the right.
    const std::vector<Piece>& pieces() const { return pieces_; }

    /// Linear light of the piece that holds f (to the right of a break), evaluated at g: the piece
    /// is extended as far as g - f reaches.
    Vec3d extended(double f, double g) const;

    /// The mean of the map over one period (`repeat`); zero with `clamp`.
    const Vec3d& mean() const { return mean_; }
    /// The first antiderivative at f of the map less mean(); periodic with `repeat`.
    Vec3d first(double f) const;
    /// The second antiderivative at f, up to a linear function, which second differences take out.
    Vec3d second(double f) const;

  private:
    void fill_pieces(const ColorMap& map);
    void take_mean_out();
    void integrate();
    void fill_breaks();
    const Piece& piece(double t) const;
    double index(double f) const;

    Wrap wrap_;
    std::vector<Piece> pieces_;
    std::vector<MapBreak> breaks_;
    Vec3d mean_{0.0};
};

/// The distance from an index to the nearest break of the colour map: a footprint without a break
/// inside has the colour at its middle, so that most texels of a smooth texture need no filter.
class BreakDistance {
  public:
    static constexpr std::uint32_t entry_count = 4096;

    explicit BreakDistance(const MapPieces& map);

    /// Whether the map is straight within `half` of every f whose map_index lies in the entry.
    bool straight(std::uint32_t entry, double half) const {
        return half < double(distances_[entry]);
    }
    /// The distances of all entries to the nearest break, rounded down by a relative 1e-6.
    const float* data() const { return distances_.data(); }

  private:
    std::vector<float> distances_;  ///< entry_count + 1 distances: index 1 has an entry of its own
};

}  // namespace burl
