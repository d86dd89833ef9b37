#include "procedural/fill/mask_images.h"

#include <fmt/format.h>

#include "atlas/base/error.h"

namespace burl {

void check_masks(const TextureGraph& graph, GraphOutput output, const MaskImages& masks,
                 std::size_t size) {
    const std::vector<bool> read = masks_read(graph, output);
    for (std::size_t m = 0; m < read.size(); ++m) {
        const bool there = m < masks.size() && masks[m] && masks[m]->width() == size;
        if (read[m] && !there)
            throw Error(ExitCode::unsupported,
                        fmt::format("the texture cannot be filled: {}; bake it",
                                    no_texels_for(first_mask_node(graph, output))));
    }
}

}  // namespace burl
