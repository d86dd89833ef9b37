#pragma once
// The colour map as a function on the whole line: linear pieces between breakpoints, each with the
// jump and the kink there, and the map's first and second antiderivative. Filters integrate the
// map exactly from this; a table of colours (Hart et al. 1999, section 3.3) only approximates it.
//
// With `repeat` the antiderivatives are those of the map less its mean and are made periodic, so
// they are as exact at f = 1e9 as at 0. With `clamp` they go on beyond the ends as polynomials.
#include <vector>

#include "atlas/base/vec.h"
#include "procedural/color/map.h"

namespace burl {

/// Where the map is not smooth: from here on the colour is `jump` higher and the slope `kink`
/// steeper than to the left.
struct MapBreak {
    double position = 0.0;  ///< in [0,1]; with `repeat` in [0,1), and again every 1
    Vec3d jump{0.0}, kink{0.0};
};

class MapPieces {
  public:
    struct Piece {
        double start = 0.0;
        Vec3d color{0.0}, slope{0.0};   ///< c(start + x) = color + slope x, less mean()
        Vec3d first{0.0}, second{0.0};  ///< antiderivatives at start
    };
    explicit MapPieces(const ColorMap& map);

    Wrap wrap() const { return wrap_; }
    /// Ascending by position; positions of which nothing breaks are left out.
    const std::vector<MapBreak>& breaks() const { return breaks_; }
    /// Ascending by start; the first goes on to the left, the last to the right.
    const std::vector<Piece>& pieces() const { return pieces_; }

    /// Linear light of the piece that holds f (to the right of a break), evaluated at g: the piece
    /// is extended as far as g - f reaches.
    Vec3d extended(double f, double g) const;

    /// Mean of the map over one period (`repeat`); zero with `clamp`.
    const Vec3d& mean() const { return mean_; }
    /// First antiderivative at f of the map less mean(); periodic with `repeat`.
    Vec3d first(double f) const;
    /// Second antiderivative at f, up to a linear function, which second differences take out.
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

}  // namespace burl
