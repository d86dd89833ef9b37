#include "atlas/solid/tiles.h"

namespace burl {

SolidAtlas cut_to(const SolidAtlas& solid, const TexelSet& wanted) {
    SolidAtlas part;
    part.size = solid.size;
    part.maps = solid.maps;
    part.turned = solid.turned;
    part.row_begin.reserve(solid.row_begin.size());
    for (std::uint32_t y = 0; y < solid.size; ++y) {
        part.row_begin.push_back(part.spans.size());
        for (const Span& span : solid.row(y)) {
            const WholeSpan whole = solid.whole(span);
            wanted.for_each_run(y, {span.x, span.x + span.count},
                                [&](std::uint32_t first, std::uint32_t last) {
                                    part.spans.push_back({first, last - first, span.map});
                                    part.wholes.push_back(whole);
                                });
        }
    }
    part.row_begin.push_back(part.spans.size());
    return part;
}

std::uint64_t texel_count(const SolidAtlas& solid) {
    std::uint64_t count = 0;
    for (const Span& span : solid.spans) count += span.count;
    return count;
}

}  // namespace burl
