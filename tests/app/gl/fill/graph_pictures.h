#pragma once
// Pictures of graphs by OpenGL and by the host, and how they differ.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <type_traits>

#include <gtest/gtest.h>

#include "app/gl/fill/synthesize.h"
#include "procedural/fill/graph.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {

inline const Affine3 graph_somewhere{Mat3d(1.7), Vec3d(0.3, -0.2, 0.1)};

template <class Pixel>
Image<Pixel> on_host(const SolidAtlas& solid, const TextureGraph& graph, const Affine3& map) {
    if constexpr (std::is_same_v<Pixel, Rgb8>)
        return synthesize_graph<Rgb8>(solid, graph, map, Filter{}, 1);
    else if constexpr (std::is_same_v<Pixel, Rgb16>)
        return synthesize_graph<Rgb16>(solid, graph, map, Filter{}, 1);
    else
        return synthesize_graph<RgbF>(solid, graph, map, Filter{}, 1);
}

template <class Pixel>
Image<Pixel> drawn(GlSynthesis& gl, const SolidAtlas& solid, const TextureGraph& graph,
                   const Affine3& map) {
    Image<Pixel> image;
    gl.synthesize(solid, graph, map, 1, image);
    return image;
}

inline std::size_t colors_of(const Image<RgbF>& image) {
    std::set<std::array<float, 3>> colors;
    for (const RgbF& c : image.pixels()) colors.insert({c.r, c.g, c.b});
    return colors.size();
}

/// Share of texels that are further apart than `error` in some channel.
inline double share_beyond(const Image<RgbF>& a, const Image<RgbF>& b, double error) {
    double beyond = 0.0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const RgbF &p = a.pixels()[i], &q = b.pixels()[i];
        const double away =
            std::max({std::abs(double(p.r) - double(q.r)), std::abs(double(p.g) - double(q.g)),
                      std::abs(double(p.b) - double(q.b))});
        beyond += away <= error ? 0.0 : 1.0;
    }
    return beyond / double(a.pixels().size());
}

/// Linear light, which 8- and 16-bit codes follow from.
inline void expect_equal(GlSynthesis& gl, std::string_view name, const TextureGraph& graph,
                         const SolidAtlas& solid) {
    const Image<RgbF> expected = on_host<RgbF>(solid, graph, graph_somewhere);
    EXPECT_EQ(differing(drawn<RgbF>(gl, solid, graph, graph_somewhere), expected), 0u) << name;
    if (name != "constant" && name != "slope") {
        EXPECT_GT(colors_of(expected), 1u) << name;
    }
}

}  // namespace burl
