#include "procedural/maps/lattice_box.h"

#include <limits>

namespace burl {

LatticeBox lattice_box(const SolidAtlas& solid, const Affine3& lattice_from_atlas) {
    if (solid.spans.empty()) return {};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    LatticeBox box{Vec3d(infinity), Vec3d(-infinity)};
    for (std::size_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (const std::uint32_t x : {span.x, span.x + span.count - 1}) {
                const Vec3d p = lattice_from_atlas(solid.maps[span.map](x, std::int64_t(y)));
                box.low = glm::min(box.low, p), box.high = glm::max(box.high, p);
            }
    return box;
}

}  // namespace burl
