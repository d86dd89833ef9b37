#include "app/edit/paint_layers.h"

#include <algorithm>
#include <set>

#include "procedural/graph/masks.h"

namespace burl {

std::vector<int> paint_layers(const Recipe& recipe) {
    std::set<int> layers;
    for (const TextureGraph* graph : {&recipe.texture, &recipe.bump.input})
        for (const GraphMask& mask : graph_masks(*graph))
            if (mask.kind == MaskKind::paint) layers.insert(int(mask.numbers[0]));
    for (const PaintStroke& stroke : recipe.paint) layers.insert(stroke.layer);
    layers.erase(0);
    return {layers.begin(), layers.end()};
}

int free_paint_layer(const Recipe& recipe) {
    const std::vector<int> known = paint_layers(recipe);
    int layer = 1;
    while (layer < most_paint_layers && std::ranges::binary_search(known, layer)) ++layer;
    return layer;
}

}  // namespace burl
