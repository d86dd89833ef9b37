#include "app/recipe/paint_stroke.h"

#include <algorithm>
#include <iterator>

namespace burl {

std::vector<PaintStroke> strokes_of(std::span<const PaintStroke> strokes, int layer) {
    std::vector<PaintStroke> found;
    std::ranges::copy_if(strokes, std::back_inserter(found),
                         [&](const PaintStroke& stroke) { return stroke.layer == layer; });
    return found;
}

std::vector<PaintStroke> mask_strokes(std::span<const PaintStroke> strokes) {
    std::vector<PaintStroke> found;
    std::ranges::copy_if(strokes, std::back_inserter(found),
                         [](const PaintStroke& stroke) { return stroke.layer != 0; });
    return found;
}

bool has_color_paint(std::span<const PaintStroke> strokes) {
    return std::ranges::count(strokes, 0, &PaintStroke::layer) > 0;
}

}  // namespace burl
