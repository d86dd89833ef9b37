#include "procedural/color/map.h"

#include <algorithm>

#include "procedural/color/srgb.h"
#include "procedural/color/table.h"

namespace burl {

Vec3d evaluate_color(const ColorMap& map, double f) {
    if (map.stops.empty()) return Vec3d(0.0);
    const double t = map_index(map.wrap, f);
    ColorStop before = map.stops.back(), after = map.stops.front();
    if (map.wrap == Wrap::repeat) {
        before.position -= 1.0;
        if (t >= map.stops.back().position) before.position += 1.0, after.position += 1.0;
    }
    for (const ColorStop& stop : map.stops) {
        if (stop.position <= t) before = stop;
    }
    for (auto stop = map.stops.rbegin(); stop != map.stops.rend(); ++stop) {
        if (stop->position > t) after = *stop;
    }
    if (map.wrap == Wrap::clamp && t < map.stops.front().position) before = map.stops.front();
    if (map.wrap == Wrap::clamp && t >= map.stops.back().position) after = map.stops.back();
    const double width = after.position - before.position;
    const double weight = width > 0.0 ? (t - before.position) / width : 0.0;
    return light_of(before) + weight * (light_of(after) - light_of(before));
}

Vec3d light_of(const ColorStop& stop) {
    return stop.alpha / 255.0 * linear_light(stop.color);
}

bool is_opaque(const ColorMap& map) {
    return std::ranges::all_of(map.stops, [](const ColorStop& stop) { return stop.alpha == 255; });
}

ColorMap alpha_map(ColorMap map) {
    for (ColorStop& stop : map.stops) stop.color = {255, 255, 255};
    return map;
}

}  // namespace burl
