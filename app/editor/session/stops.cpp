#include "app/editor/session/stops.h"

#include <algorithm>
#include <cmath>

#include "procedural/color/table.h"

namespace burl {

std::vector<ColorStop> with_stop_moved(std::vector<ColorStop> stops, std::size_t index,
                                       double position) {
    const double low = index > 0 ? stops[index - 1].position : 0.0;
    const double high = index + 1 < stops.size() ? stops[index + 1].position : 1.0;
    stops[index].position = std::clamp(position, low, high);
    return stops;
}

std::vector<ColorStop> with_stop_added(const ColorMap& map, double position, std::size_t& at) {
    const double place = std::clamp(position, 0.0, 1.0);
    const ColorStop added{
        place, ColorTable8(map)(map.wrap == Wrap::repeat && place == 1.0 ? std::nextafter(1.0, 0.0)
                                                                         : place)};
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

std::vector<Rgb8> map_colors(const ColorMap& map, std::size_t count) {
    const ColorTable8 table(map);
    std::vector<Rgb8> colors(count);
    const double last = std::nextafter(1.0, 0.0);
    for (std::size_t i = 0; i < count; ++i)
        colors[i] = table(std::min(double(i) / double(std::max<std::size_t>(count - 1, 1)), last));
    return colors;
}

}  // namespace burl
