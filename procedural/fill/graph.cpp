#include "procedural/fill/graph.h"

#include "procedural/color/pixel_encoder.h"
#include "procedural/fill/graph_points.h"
#include "procedural/fill/graph_texels.h"

namespace burl {

namespace {

struct GraphColor {
    Vec3d operator()(const TexelPlace&, double, double, const GraphSample& sample) const {
        return sample.color();
    }
};

template <class Pixel>
Image<Pixel> synthesize_points(const SolidAtlas& solid, const TextureGraph& graph,
                               const Affine3& map, const Filter& filter, int threads,
                               const Economy& economy, const RowWindow& rows,
                               const MaskImages& masks) {
    const GraphValues values(graph, &economy.skips);
    GraphValues::Scratch scratch = values.make_scratch();
    Image<Pixel> image(solid.size, rows.count(),
                       PixelEncoder<Pixel>()(values(Vec3d(0.0), scratch)));
    fill_points(solid, map, values, filter, threads, economy, RowBand(image, rows.first), masks);
    return image;
}

}  // namespace

template <class Pixel>
Image<Pixel> synthesize_graph(const SolidAtlas& solid, const TextureGraph& graph,
                              const Affine3& map, const Filter& filter, int threads,
                              PrecisionKind precision, const Economy& economy,
                              const RowWindow& window, const MaskImages& masks) {
    check_masks(graph, GraphOutput::color, masks, solid.size);
    const RowWindow rows = window.of(solid.size);
    const bool points = filter.kind == FilterKind::none || filter.kind == FilterKind::supersample;
    if (points && precision == PrecisionKind::float32)
        return synthesize_points<Pixel>(solid, graph, map, filter, threads, economy, rows, masks);
    const PixelEncoder<Pixel> encode{};
    const GraphEvaluator evaluate(graph, filter, precision);
    Image<Pixel> image(solid.size, rows.count(), encode(evaluate(Vec3d(0.0)).color()));
    fill_texels(solid, map, evaluate, filter, GraphColor{}, encode, threads,
                RowBand(image, rows.first), economy, masks);
    if (economy.work) *economy.work += work_of(solid, rows, GraphValues(graph).program(), filter);
    return image;
}

template Image<Rgb8> synthesize_graph(const SolidAtlas&, const TextureGraph&, const Affine3&,
                                      const Filter&, int, PrecisionKind, const Economy&,
                                      const RowWindow&, const MaskImages&);
template Image<Rgb16> synthesize_graph(const SolidAtlas&, const TextureGraph&, const Affine3&,
                                       const Filter&, int, PrecisionKind, const Economy&,
                                       const RowWindow&, const MaskImages&);
template Image<RgbF> synthesize_graph(const SolidAtlas&, const TextureGraph&, const Affine3&,
                                      const Filter&, int, PrecisionKind, const Economy&,
                                      const RowWindow&, const MaskImages&);

}  // namespace burl
