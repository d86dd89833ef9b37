#include "procedural/color_table.h"

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
        if (width > 0.0) segments_[i].slope = (segments_[i + 1].color - segments_[i].color) / width;
    }
}

ColorTable8::ColorTable8(const ColorMap& map) : map_(map), entries_(entry_count + 1) {
    // Within a segment every channel is monotone, so equal codes at both ends hold in between.
    std::size_t segment = map_.segment(0.0);
    entries_[0].color = encode(map_.color(segment, 0.0));
    for (std::uint32_t i = 0; i < entry_count; ++i) {
        const double end = double(i + 1) / entry_count;
        const std::size_t end_segment = map_.segment(end);
        entries_[i + 1].color = encode(map_.color(end_segment, end));
        entries_[i].uniform = segment == end_segment && entries_[i].color == entries_[i + 1].color;
        segment = end_segment;
    }
}

}  // namespace burl
