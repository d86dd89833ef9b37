// Nodes of colours: the map of the 1999 model over any number, filtered exactly by the number's
// gradient, and Porter and Duff's "over" (1984).
#include "procedural/graph/nodes.h"

namespace burl::nodes {

void color_map(const NodeCall& call) {
    const MapPieces& map = call.prepared->pieces.front();
    const FilteredColors& mean = call.prepared->colors.front();
    for (std::size_t i = 0; i < call.count(); ++i) {
        const Dual f = call.input(0, i);
        const double u = call.along_u(f, i), v = call.along_v(f, i);
        const double x = std::isfinite(f.value) ? f.value : 0.0, width = length_of(u, v);
        const Vec3d color = mean(x, u, v);
        Vec3d derivative = map.extended(x, x + 1.0) - map.extended(x, x);
        if (width > 1e-6)
            derivative = (map.extended(x + 0.5 * width, x + 0.5 * width) -
                          map.extended(x - 0.5 * width, x - 0.5 * width)) /
                         width;
        for (int c = 0; c < 3; ++c)
            call.out[std::size_t(c)].set(i, chain(f, color[c], derivative[c]));
        call.out[3].set(i, 1.0);
    }
}

void layer_over(const NodeCall& call) {
    for (std::size_t i = 0; i < call.count(); ++i) {
        const Dual opacity = dual_min(1.0, dual_max(0.0, call.input(2, i)));
        const Dual shows = 1.0 - opacity * call.input(0, i, 3);
        for (std::size_t c = 0; c < 4; ++c)
            call.out[c].set(i, opacity * call.input(0, i, c) + shows * call.input(1, i, c));
    }
}

}  // namespace burl::nodes
