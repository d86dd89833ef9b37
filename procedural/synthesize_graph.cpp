#include "procedural/synthesize_graph.h"

#include "procedural/pixel_encoder.h"
#include "procedural/synthesize_graph_texels.h"

namespace burl {

namespace {

struct GraphColor {
    Vec3d operator()(const TexelPlace&, double, double, const GraphSample& sample) const {
        return sample.color();
    }
};

template <class Pixel>
Image<Pixel> synthesize(const SolidAtlas& solid, const TextureGraph& graph, const Affine3& map,
                        const Filter& filter, int threads) {
    const PixelEncoder<Pixel> encode{};
    const GraphEvaluator evaluate(graph, filter);
    Image<Pixel> image(solid.size, solid.size, encode(evaluate(Vec3d(0.0)).color()));
    fill_texels(solid, map, evaluate, filter, GraphColor{}, encode, threads, image);
    return image;
}

}  // namespace

Image<Rgb8> synthesize_graph_rgb8(const SolidAtlas& solid, const TextureGraph& graph,
                                  const Affine3& map, const Filter& filter, int threads) {
    return synthesize<Rgb8>(solid, graph, map, filter, threads);
}

Image<Rgb16> synthesize_graph_rgb16(const SolidAtlas& solid, const TextureGraph& graph,
                                    const Affine3& map, const Filter& filter, int threads) {
    return synthesize<Rgb16>(solid, graph, map, filter, threads);
}

Image<RgbF> synthesize_graph_rgbf(const SolidAtlas& solid, const TextureGraph& graph,
                                  const Affine3& map, const Filter& filter, int threads) {
    return synthesize<RgbF>(solid, graph, map, filter, threads);
}

}  // namespace burl
