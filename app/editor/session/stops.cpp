#include "app/editor/session/stops.h"

#include <algorithm>
#include <cmath>

#include "procedural/color/srgb.h"
#include "procedural/color/table.h"

namespace burl {

namespace {

/// The colour and alpha of a map at f as a stop has them; black where all is transparent.
ColorStop stop_of(const ColorMap& map, double position, double f) {
    if (is_opaque(map)) return {position, ColorTable8(map)(f)};
    const double alpha = evaluate_color(alpha_map(map), f).x;
    const Vec3d light = evaluate_color(map, f) / std::max(alpha, 1e-9);
    const SrgbEncoder<std::uint8_t> encode;
    return {position,
            {encode(light.x), encode(light.y), encode(light.z)},
            std::uint8_t(std::lround(255.0 * alpha))};
}

}  // namespace

std::vector<ColorStop> with_stop_moved(std::vector<ColorStop> stops, std::size_t& at,
                                       double position) {
    ColorStop moved = stops[at];
    const bool up = position > moved.position;
    moved.position = std::clamp(position, 0.0, 1.0);
    stops.erase(stops.begin() + std::ptrdiff_t(at));
    const auto positions = &ColorStop::position;
    const auto place = up ? std::ranges::upper_bound(stops, moved.position, {}, positions)
                          : std::ranges::lower_bound(stops, moved.position, {}, positions);
    at = std::size_t(place - stops.begin());
    stops.insert(place, moved);
    return stops;
}

std::vector<ColorStop> with_stop_moved_between(std::vector<ColorStop> stops, std::size_t index,
                                               double position) {
    const double low = index > 0 ? stops[index - 1].position : 0.0;
    const double high = index + 1 < stops.size() ? stops[index + 1].position : 1.0;
    stops[index].position = std::clamp(position, low, high);
    return stops;
}

std::vector<ColorStop> with_stop_added(const ColorMap& map, double position, std::size_t& at) {
    const double place = std::clamp(position, 0.0, 1.0);
    const bool wraps = map.wrap == Wrap::repeat && place == 1.0;
    const ColorStop added = stop_of(map, place, wraps ? std::nextafter(1.0, 0.0) : place);
    std::vector<ColorStop> stops = map.stops;
    const auto next = std::ranges::upper_bound(stops, place, {}, &ColorStop::position);
    at = std::size_t(next - stops.begin());
    stops.insert(next, added);
    return stops;
}

std::vector<ColorStop> with_stop_removed(std::vector<ColorStop> stops, std::size_t index) {
    if (stops.size() > 1) stops.erase(stops.begin() + std::ptrdiff_t(index));
    return stops;
}

std::vector<Rgb8> map_colors(const ColorMap& map, std::size_t count, const Rgb8& behind) {
    const PreparedColorMap light(map), alpha(alpha_map(map));
    const SrgbEncoder<std::uint8_t> encode;
    std::vector<Rgb8> colors(count);
    const double last = std::nextafter(1.0, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
        const double f = std::min(double(i) / double(std::max<std::size_t>(count - 1, 1)), last);
        const Vec3d shown = light(f) + (1.0 - alpha(f).x) * linear_light(behind);
        colors[i] = {encode(shown.x), encode(shown.y), encode(shown.z)};
    }
    return colors;
}

}  // namespace burl
