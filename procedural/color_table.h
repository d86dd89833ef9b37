#pragma once
// The colour map prepared for millions of look-ups: stops decoded once, and for 8-bit pictures the
// list of indices at which the final code changes, with a table over the index that holds the code
// wherever it is the same over the whole entry (most of them) and where in the list to look
// elsewhere. So the table costs no accuracy and keeps the map's jumps where they are.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/vec.h"
#include "procedural/color_kernels.h"
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
    /// Where segment i begins: below 0 and above 1 at the ends.
    double begin(std::size_t i) const { return segments_[i].position; }
    std::size_t segments() const { return segments_.size(); }
    /// What the colour of segment i gains per unit of the index.
    const Vec3d& slope(std::size_t i) const { return segments_[i].slope; }
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

/// Field values to sRGB8 colours, correctly rounded.
class ColorTable8 {
  public:
    static constexpr std::uint32_t entry_count = 16384;

    explicit ColorTable8(const ColorMap& map);

    /// Code of c(f). `entry` is floor(map_index(f) * entry_count).
    Rgb8 color(std::uint32_t entry, double f) const {
        return entries_[entry].uniform ? entries_[entry].color : searched(entry, f);
    }
    Rgb8 operator()(double f) const {
        return color(std::uint32_t(map_index(wrap_, f) * entry_count), f);
    }
    /// codes[j].color = color(entries[j], f[j]); arrays as look_up_codes takes them.
    void look_up(const std::int32_t* entries, const double* f, std::size_t count, ColorCode* codes,
                 std::uint32_t* later) const;
    Wrap wrap() const { return wrap_; }

    /// From this index on the code is `color`.
    struct Step {
        double index = 0.0;
        Rgb8 color;
    };
    /// By rising index, the first at 0; one at infinity ends them.
    std::span<const Step> steps() const { return steps_; }

  private:
    static std::vector<Step> steps_of(const PreparedColorMap& map);
    /// The colour of an entry that has several.
    Rgb8 searched(std::uint32_t entry, double f) const {
        const double t = map_index(wrap_, f);
        std::uint32_t i = first_step_[entry];
        i += steps_[i + 1].index <= t ? 1 : 0;  // the one most have more, without a branch
        while (steps_[i + 1].index <= t) ++i;
        return steps_[i].color;
    }

    Wrap wrap_;
    std::vector<Step> steps_;                ///< and one at infinity
    std::vector<ColorCode> entries_;         ///< entry_count + 1: index 1 has one of its own
    std::vector<std::uint32_t> first_step_;  ///< per entry: the last step up to its begin
};

}  // namespace burl
