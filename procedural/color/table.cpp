#include "procedural/color/table.h"

#include <algorithm>
#include <bit>
#include <limits>

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/color/table.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/numbers/set_bits-inl.h"
#include "procedural/numbers/vector_types-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

static_assert(sizeof(ColorCode) == 4 && sizeof(Rgb8) == 3);

/// The colour map's index of f, as map_index gives it.
HWY_ATTR HWY_INLINE Double MapIndex(Wrap wrap, Double f) {
    const Doubles d;
    const auto zero = hn::Zero(d), one = hn::Set(d, 1.0);
    // Both wraps give 0 for NaN, because comparisons with NaN are false.
    const auto part = hn::Sub(f, hn::Floor(f));
    const auto positive = hn::IfThenElseZero(hn::Gt(f, zero), f);
    return wrap == Wrap::repeat ? hn::IfThenElseZero(hn::Lt(part, one), part)
                                : hn::IfThenElse(hn::Lt(positive, one), positive, one);
}

HWY_ATTR void IndexColors(Wrap wrap, const double* f, std::size_t count, std::uint32_t entry_count,
                          std::int32_t* entries) {
    const Doubles d;
    const auto scale = hn::Set(d, double(entry_count));
    // The loop runs to the end of a vector of floats, because tables are looked up for all of it.
    const std::size_t lanes = hn::Lanes(Floats()), end = (count + lanes - 1) / lanes * lanes;
    for (std::size_t j = 0; j < end; j += hn::Lanes(d)) {
        const auto entry = hn::Mul(MapIndex(wrap, hn::LoadU(d, f + j)), scale);
        hn::StoreU(hn::DemoteTo(HalfInts(), entry), HalfInts(), entries + j);
    }
}

HWY_ATTR std::size_t LookUpCodes(const ColorCode* table, const std::int32_t* places,
                                 std::size_t count, ColorCode* codes, std::uint32_t* later) {
    const Bits d;
    const auto* words = reinterpret_cast<const std::uint32_t*>(table);
    auto* out = reinterpret_cast<std::uint32_t*>(codes);
    const auto flag = hn::Set(d, std::bit_cast<std::uint32_t>(ColorCode{{0, 0, 0}, true}));
    std::size_t found = 0;
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        const auto entry = hn::ShiftRight<place_bits>(hn::Load(Ints(), places + j));
        const auto code = hn::GatherIndex(d, words, entry);
        hn::Store(code, d, out + j);
        const auto several = hn::Eq(hn::And(code, flag), hn::Zero(d));
        found += SetPositions(several, std::uint32_t(j), later + found);
    }
    return found_below(count, later, found);
}

HWY_ATTR void PackPixels(const ColorCode* codes, std::size_t count, Rgb8* pixels) {
    std::size_t j = 0;
#if HWY_TARGET != HWY_SCALAR
    const hn::CappedTag<std::uint8_t, 16> d;
    HWY_ALIGN static constexpr std::uint8_t order[] = {0,  1,  2,  4,  5, 6, 8, 9,
                                                       10, 12, 13, 14, 0, 0, 0, 0};
    const auto colors = hn::Load(d, order);
    // Sixteen bytes at a time; the next store overwrites the last four.
    for (; j + 6 <= count; j += 4) {
        const auto four = hn::LoadU(d, reinterpret_cast<const std::uint8_t*>(codes + j));
        hn::StoreU(hn::TableLookupBytes(four, colors), d,
                   reinterpret_cast<std::uint8_t*>(pixels + j));
    }
#endif
    for (; j < count; ++j) pixels[j] = codes[j].color;
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(IndexColors);
HWY_EXPORT(LookUpCodes);
HWY_EXPORT(PackPixels);

void index_colors(Wrap wrap, const double* f, std::size_t count, std::uint32_t entry_count,
                  std::int32_t* entries) {
    HWY_DYNAMIC_DISPATCH(IndexColors)(wrap, f, count, entry_count, entries);
}

std::size_t look_up_codes(const ColorCode* table, const std::int32_t* places, std::size_t count,
                          ColorCode* codes, std::uint32_t* later) {
    return HWY_DYNAMIC_DISPATCH(LookUpCodes)(table, places, count, codes, later);
}

void pack_pixels(const ColorCode* codes, std::size_t count, Rgb8* pixels) {
    HWY_DYNAMIC_DISPATCH(PackPixels)(codes, count, pixels);
}

PreparedColorMap::PreparedColorMap(const ColorMap& map) : wrap_(map.wrap) {
    std::vector<ColorStop> stops = map.stops;
    if (stops.empty()) stops.push_back({});
    // One stop more on either side of [0, 1]: the neighbouring period's, or the end colour again.
    ColorStop low = stops.front(), high = stops.back();
    if (wrap_ == Wrap::repeat) std::swap(low, high);
    low.position = wrap_ == Wrap::repeat ? low.position - 1.0 : -1.0;
    high.position = wrap_ == Wrap::repeat ? high.position + 1.0 : 2.0;
    stops.insert(stops.begin(), low);
    stops.push_back(high);
    for (const ColorStop& stop : stops)
        segments_.push_back({stop.position, light_of(stop), Vec3d(0.0)});
    for (std::size_t i = 0; i + 1 < segments_.size(); ++i) {
        const double width = segments_[i + 1].position - segments_[i].position;
        // Closer stops are a jump: no slope leads from one to the other.
        if (width > 1e-300)
            segments_[i].slope = (segments_[i + 1].color - segments_[i].color) / width;
    }
}

namespace {

/// The least double in (low, high] for which `reached` holds. `reached` must hold for high, not for
/// low, and for every number above one for which it holds. The search starts within `margin` of
/// `guess`.
template <class Predicate>
double least(double low, double high, double guess, double margin, Predicate&& reached) {
    if (guess - margin > low && !reached(guess - margin)) low = guess - margin;
    if (guess + margin < high && reached(guess + margin)) high = guess + margin;
    for (double middle = 0.5 * (low + high); low < middle && middle < high;
         middle = 0.5 * (low + high))
        (reached(middle) ? high : low) = middle;
    return high;
}

/// An index at which one channel of the code becomes `code`.
struct Change {
    double index;
    std::uint8_t Rgb8::*channel;
    std::uint8_t code;
};

/// Appends the changes of one channel within ]begin, end[ of a segment, where it is monotone.
void add_changes(const PreparedColorMap& map, const SrgbEncoder<std::uint8_t>& encode,
                 std::size_t segment, double begin, double end, glm::length_t axis,
                 std::vector<Change>& changes) {
    static constexpr std::uint8_t Rgb8::*channels[] = {&Rgb8::r, &Rgb8::g, &Rgb8::b};
    const auto light = [&](double t) { return map.color(segment, t)[axis]; };
    const double last = std::nextafter(end, begin);
    const int target = encode(light(last));
    const double slope = (light(last) - light(begin)) / (last - begin);
    const double margin = 0x1p-50 * (1.0 + 1.0 / std::abs(slope));
    for (int code = encode(light(begin)); code != target;) {
        const bool up = target > code;
        const double threshold = encode.threshold(std::uint8_t(up ? code : code - 1));
        code += up ? 1 : -1;
        const double guess = begin + (threshold - light(begin)) / slope;
        const double index = least(begin, last, guess, margin, [&](double t) {
            return up ? light(t) >= threshold : light(t) < threshold;
        });
        changes.push_back({index, channels[axis], std::uint8_t(code)});
    }
}

}  // namespace

std::vector<ColorTable8::Step> ColorTable8::steps_of(const PreparedColorMap& map) {
    const SrgbEncoder<std::uint8_t> encode;
    const double after = std::nextafter(1.0, 2.0);
    std::vector<Step> steps;
    for (std::size_t i = 0; i + 1 < map.segments(); ++i) {
        const double begin = std::max(map.begin(i), 0.0), end = std::min(map.begin(i + 1), after);
        if (begin >= end) continue;
        const Vec3d light = map.color(i, begin);
        Step step{begin, {encode(light.r), encode(light.g), encode(light.b)}};
        steps.push_back(step);
        std::vector<Change> changes;
        for (glm::length_t axis = 0; axis < 3; ++axis)
            add_changes(map, encode, i, begin, end, axis, changes);
        std::ranges::sort(changes, {}, &Change::index);
        for (const Change& change : changes) {
            step.color.*change.channel = change.code;
            step.index = change.index;
            if (steps.back().index < change.index)
                steps.push_back(step);
            else
                steps.back() = step;
        }
    }
    steps.push_back({std::numeric_limits<double>::infinity(), {}});
    return steps;
}

ColorTable8::ColorTable8(const ColorMap& map)
    : wrap_(map.wrap), steps_(steps_of(PreparedColorMap(map))) {
    constexpr double most = std::numeric_limits<std::uint32_t>::max();
    for (const Step& step : steps_)
        step_places_.push_back(std::uint32_t(std::min(step.index * places, most)));
    fill_entries();
}

void ColorTable8::fill_entries() {
    constexpr std::uint32_t count = places >> place_bits;
    entries_.resize(count + 1);
    std::uint32_t begin = 0;
    for (std::uint32_t s = 0; begin <= count; ++s) {
        // The entries that begin before the next step, which may lie within the last of them.
        const double next = steps_[s + 1].index * count;
        const auto end = std::max(begin, std::uint32_t(std::min(std::ceil(next), count + 1.0)));
        if (begin == end) continue;
        std::fill(entries_.begin() + begin, entries_.begin() + end,
                  ColorCode{steps_[s].color, true});
        if (next < end) entries_[end - 1] = numbered(add_parts(end - 1, s));
        begin = end;
    }
}

/// Appends the block of parts of a table entry and returns the block's number; `step` is the last
/// step at or before the entry's begin.
std::uint32_t ColorTable8::add_parts(std::uint32_t entry, std::uint32_t step) {
    constexpr std::uint32_t count = 1u << part_bits;
    const auto number = std::uint32_t(parts_.size()) / count;
    for (std::uint32_t part = entry * count; part < (entry + 1) * count; ++part) {
        const auto index_of_next = [&] {
            return steps_[step + 1].index * double(places >> place_bits) * count;
        };
        while (index_of_next() <= part) ++step;
        const bool uniform = index_of_next() >= part + 1.0;
        parts_.push_back(uniform ? ColorCode{steps_[step].color, true} : numbered(step));
    }
    return number;
}

void ColorTable8::look_up(const std::int32_t* at, const double* f, std::size_t count,
                          ColorCode* codes, std::uint32_t* later) const {
    const std::size_t several = look_up_codes(entries_.data(), at, count, codes, later);
    std::size_t searches = 0;
    for (std::size_t i = 0; i < several; ++i) {
        const std::uint32_t j = later[i];
        const ColorCode part = part_of(codes[j], std::uint32_t(at[j]));
        codes[j] = part;
        later[searches] = j;
        searches += part.uniform ? 0 : 1;
    }
    for (std::size_t i = 0; i < searches; ++i) {
        const std::uint32_t j = later[i];
        codes[j].color = searched(codes[j], std::uint32_t(at[j]), f[j]);
    }
}

}  // namespace burl
#endif
