#pragma once
// The colour map prepared for millions of look-ups: stops decoded once, and for 8-bit pictures a
// table over the index whose entries hold the final code wherever the code is the same over the
// whole entry (most of them); the others are computed. So the table costs no accuracy and keeps the
// map's jumps where they are.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "atlas/vec.h"
#include "procedural/color_map.h"
#include "procedural/srgb.h"

namespace burl {

/// The map's index of f: clamped to [0,1], or modulo one in [0,1). What is not finite counts as 0
/// with `repeat`, and NaN as 0 with `clamp`.
inline double map_index(Wrap wrap, double f) {
    if (wrap == Wrap::clamp) return f > 0.0 ? std::min(f, 1.0) : 0.0;
    const double t = f - std::floor(f);
    return t < 1.0 ? t : 0.0;  // -1e-20 - floor(-1e-20) rounds to 1
}

/// c(f) with the stops' linear light worked out beforehand.
class PreparedColorMap {
  public:
    explicit PreparedColorMap(const ColorMap& map);

    Wrap wrap() const { return wrap_; }

    /// The segment that holds index t.
    std::size_t segment(double t) const {
        std::size_t i = 0;
        while (i + 1 < segments_.size() && t >= segments_[i + 1].position) ++i;
        return i;
    }
    /// Linear light at index t of segment i.
    Vec3d color(std::size_t i, double t) const {
        return segments_[i].color + (t - segments_[i].position) * segments_[i].slope;
    }
    /// Linear light c(f), equal to evaluate_color up to rounding in the last places of a double.
    Vec3d operator()(double f) const {
        const double t = map_index(wrap_, f);
        return color(segment(t), t);
    }

  private:
    struct Segment {
        double position = 0.0;
        Vec3d color{0.0}, slope{0.0};
    };
    Wrap wrap_;
    std::vector<Segment> segments_;
};

/// Field values to sRGB8 colours.
class ColorTable8 {
  public:
    static constexpr std::uint32_t entry_count = 16384;

    explicit ColorTable8(const ColorMap& map);

    /// Code of c(f), correctly rounded. `entry` is floor(map_index(f) * entry_count).
    Rgb8 color(std::uint32_t entry, double f) const {
        const Entry& e = entries_[entry];
        return e.uniform ? e.color : encode(map_(f));
    }
    Rgb8 operator()(double f) const {
        return color(std::uint32_t(map_index(map_.wrap(), f) * entry_count), f);
    }
    Wrap wrap() const { return map_.wrap(); }

  private:
    struct Entry {
        Rgb8 color;
        bool uniform = false;
    };
    Rgb8 encode(const Vec3d& linear) const {
        return {encode_(linear.x), encode_(linear.y), encode_(linear.z)};
    }
    PreparedColorMap map_;
    SrgbEncoder<std::uint8_t> encode_;
    std::vector<Entry> entries_;  ///< entry_count + 1: index 1 has one of its own
};

}  // namespace burl
