// pbrt's image texture, over the first two coordinates of the point.
#include <algorithm>

#include "procedural/graph/nodes.h"

namespace burl::nodes {

void image(const NodeCall& call) {
    const MipImage& pixels = *call.graph->images[call.node->image].pixels;
    const bool ewa = call.parameter("lookup") == 1.0;
    const double anisotropy = call.parameter("anisotropy");
    for (std::size_t i = 0; i < call.count(); ++i) {
        const Dual s = call.place[0].get(i), t = call.place[1].get(i);
        const Vec2d u(call.along_u(s, i), call.along_u(t, i)),
            v(call.along_v(s, i), call.along_v(t, i));
        const double width =
            2.0 * std::max({std::abs(u.x), std::abs(u.y), std::abs(v.x), std::abs(v.y)});
        const ImageSample sample = ewa ? pixels.ewa(s.value, t.value, u, v, anisotropy)
                                       : pixels.trilinear(s.value, t.value, width);
        for (int c = 0; c < 3; ++c)
            call.out[std::size_t(c)].set(
                i, {sample.color[c], sample.by_s[c] * s.slope + sample.by_t[c] * t.slope});
        call.out[3].set(i, 1.0);
    }
}

}  // namespace burl::nodes
