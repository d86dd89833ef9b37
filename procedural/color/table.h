#pragma once
// The colour map prepared for millions of look-ups: stops decoded once, and for 8-bit pictures the
// list of indices at which the final code changes. A table over the index holds the code where it
// is the same over the whole entry (most entries), a finer table of the entry's parts elsewhere,
// and where a part has several codes the place in the list from which to search. So the table costs
// no accuracy and keeps the map's jumps where they are.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/base/vec.h"
#include "procedural/color/map.h"
#include "procedural/color/srgb.h"

namespace burl {

/// The map's index of f: clamped to [0, 1], or modulo one in [0, 1). With `repeat` infinite values
/// and NaN count as 0; with `clamp` NaN counts as 0.
inline double map_index(Wrap wrap, double f) {
    if (wrap == Wrap::clamp) return f > 0.0 ? std::min(f, 1.0) : 0.0;
    const double t = f - std::floor(f);
    return t < 1.0 ? t : 0.0;  // -1e-20 - floor(-1e-20) rounds to 1
}

/// The colour map c(f) with the stops converted to linear light beforehand.
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
    /// The index where segment i begins: below 0 and above 1 at the ends.
    double begin(std::size_t i) const { return segments_[i].position; }
    std::size_t segments() const { return segments_.size(); }
    /// The change of segment i's colour per unit of the index.
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

// The last steps of an 8-bit texture, vectorised as in texel_batch.h: places in a table, codes from
// it, and pixels of three bytes from codes of four.

/// entries[j] = floor(map_index(wrap, f[j]) * entry_count), computed up to the end of a vector of
/// floats.
void index_colors(Wrap wrap, const double* f, std::size_t count, std::uint32_t entry_count,
                  std::int32_t* entries);

/// An entry of a table of colours: the final sRGB code where `uniform`, otherwise a number.
struct ColorCode {
    Rgb8 color;
    bool uniform = false;
};
/// A non-uniform entry that holds `number` in its three bytes; numbers above 2^24 - 1 count as 2^24
/// - 1.
constexpr ColorCode numbered(std::size_t number) {
    const auto n = std::uint32_t(std::min<std::size_t>(number, (1u << 24) - 1));
    return {{std::uint8_t(n), std::uint8_t(n >> 8), std::uint8_t(n >> 16)}, false};
}
/// The number that a non-uniform entry holds.
constexpr std::uint32_t number_of(const ColorCode& code) {
    return code.color.r | std::uint32_t(code.color.g) << 8 | std::uint32_t(code.color.b) << 16;
}

/// The bits of a place below those that are the number of its table entry.
inline constexpr int place_bits = 16;

/// codes[j] = table[places[j] >> place_bits]. later[0..result) are the j whose code is not uniform,
/// ascending. Works on whole vectors: `places` and `codes` are aligned to 64 bytes and hold
/// batch_padding elements more than `count`, `later` 2 batch_padding more, and the padding of
/// `places` must name entries of the table, too.
std::size_t look_up_codes(const ColorCode* table, const std::int32_t* places, std::size_t count,
                          ColorCode* codes, std::uint32_t* later);

/// pixels[j] = codes[j].color for j < count; no byte beyond is written.
void pack_pixels(const ColorCode* codes, std::size_t count, Rgb8* pixels);

/// A table from field values to sRGB8 colours, correctly rounded.
class ColorTable8 {
  public:
    /// The number of places into which [0, 1) of the index is divided, so many that hardly any
    /// place has a change of colour within it.
    static constexpr std::uint32_t places = std::uint32_t(1) << 30;

    explicit ColorTable8(const ColorMap& map);

    /// The sRGB code of c(f).
    Rgb8 operator()(double f) const {
        const auto place = std::uint32_t(map_index(wrap_, f) * places);
        const ColorCode entry = entries_[place >> place_bits];
        if (entry.uniform) return entry.color;
        const ColorCode part = part_of(entry, place);
        return part.uniform ? part.color : searched(part, place, f);
    }
    /// codes[j].color = c(f[j]) for the place at[j] = floor(map_index(f[j]) * places). f is read
    /// only where the place does not decide the colour. The arrays are aligned and padded as for
    /// look_up_codes.
    void look_up(const std::int32_t* at, const double* f, std::size_t count, ColorCode* codes,
                 std::uint32_t* later) const;
    Wrap wrap() const { return wrap_; }

    /// A step of the code: from `index` on it is `color`.
    struct Step {
        double index = 0.0;
        Rgb8 color;
    };
    /// The steps by rising index: the first at 0, and a last one at infinity.
    std::span<const Step> steps() const { return steps_; }

  private:
    static constexpr int part_bits = 4;  ///< the bits of a place that number a part of its entry
    static std::vector<Step> steps_of(const PreparedColorMap& map);
    void fill_entries();
    std::uint32_t add_parts(std::uint32_t entry, std::uint32_t step);
    ColorCode part_of(ColorCode entry, std::uint32_t place) const {
        const std::uint32_t part = place >> (place_bits - part_bits) & ((1u << part_bits) - 1);
        return parts_[number_of(entry) << part_bits | part];
    }
    /// The colour of a part with several codes. Steps whose place is below that of f lie below f;
    /// only where the places are equal, f decides and is read.
    Rgb8 searched(ColorCode part, std::uint32_t place, const double& f) const {
        std::uint32_t i = number_of(part);
        while (step_places_[i + 1] < place) ++i;
        if (step_places_[i + 1] == place) {
            const double t = map_index(wrap_, f);
            while (steps_[i + 1].index <= t) ++i;
        }
        return steps_[i].color;
    }

    Wrap wrap_;
    std::vector<Step> steps_;                 ///< the steps, and one at infinity
    std::vector<std::uint32_t> step_places_;  ///< the steps' places, one per step
    /// Entries of 2^place_bits places each, and one for index 1. An entry of several colours holds
    /// the number of a block of parts instead of a colour.
    std::vector<ColorCode> entries_;
    /// Blocks of 2^part_bits parts. A part of several colours holds the number of the last step at
    /// or before its begin, or of an earlier one.
    std::vector<ColorCode> parts_;
};

}  // namespace burl
