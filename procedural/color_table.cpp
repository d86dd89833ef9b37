#include "procedural/color_table.h"

#include <algorithm>
#include <limits>

#include "procedural/color_entries.h"

namespace burl {

PreparedColorMap::PreparedColorMap(const ColorMap& map) : wrap_(map.wrap) {
    std::vector<ColorStop> stops = map.stops;
    if (stops.empty()) stops.push_back({});
    // One stop more on either side of [0,1]: the neighbouring period's, or the end colour again.
    ColorStop low = stops.front(), high = stops.back();
    if (wrap_ == Wrap::repeat) std::swap(low, high);
    low.position = wrap_ == Wrap::repeat ? low.position - 1.0 : -1.0;
    high.position = wrap_ == Wrap::repeat ? high.position + 1.0 : 2.0;
    stops.insert(stops.begin(), low);
    stops.push_back(high);
    for (const ColorStop& stop : stops)
        segments_.push_back({stop.position, linear_light(stop.color), Vec3d(0.0)});
    for (std::size_t i = 0; i + 1 < segments_.size(); ++i) {
        const double width = segments_[i + 1].position - segments_[i].position;
        // Closer stops are a jump: no slope leads from one to the other.
        if (width > 1e-300)
            segments_[i].slope = (segments_[i + 1].color - segments_[i].color) / width;
    }
}

namespace {

/// The least double in (low, high] for which `reached` holds; it does for high, not for low, and
/// for everything above one for which it does. `guess` is near.
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

/// The changes of one channel within ]begin, end[ of a segment, where it is monotone.
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
    : wrap_(map.wrap),
      steps_(steps_of(PreparedColorMap(map))),
      entries_(entry_count + 1),
      first_step_(entry_count + 1) {
    fill_color_entries(steps_, entries_, first_step_);
}

void ColorTable8::look_up(const std::int32_t* entries, const double* f, std::size_t count,
                          ColorCode* codes, std::uint32_t* later) const {
    const std::size_t searches = look_up_codes(entries_.data(), entries, count, codes, later);
    for (std::size_t i = 0; i < searches; ++i)
        codes[later[i]].color = searched(std::uint32_t(entries[later[i]]), f[later[i]]);
}

}  // namespace burl
