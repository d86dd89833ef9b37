#include "procedural/cache/graph.h"

#include "procedural/color/pixel_encoder.h"
#include "procedural/fill/graph.h"
#include "procedural/fill/graph_points.h"
#include "procedural/graph/table.h"

namespace burl {

/// Stores the first channel as it is, in float64.
template <>
class BatchEncoder<double> {
  public:
    void operator()(const std::array<const double*, 3>& c, std::size_t count,
                    double* pixels) const {
        std::copy_n(c[0], count, pixels);
    }
};

namespace {

/// The graph below the colour map, whose colours are cleared so that they are no part of the cache
/// key.
TextureGraph number_below(TextureGraph graph) {
    graph.textures[graph.nodes.back().texture] = {};
    graph.nodes.pop_back();
    graph.result = std::uint32_t(graph.nodes.size() - 1);
    return graph;
}

/// The graph of the colour map alone, over the first coordinate of the point.
TextureGraph map_alone(const TextureGraph& graph) {
    GraphNode number, map = graph.nodes.back();
    number.type = std::uint32_t(find_node("coordinate") - graph_table().data());
    number.parameters = {1.0, 0.0, 0.0, 0.0};
    map.place = 0;
    map.inputs = {1};
    TextureGraph alone;
    alone.nodes = {graph.nodes.front(), number, map};
    alone.textures = graph.textures;
    alone.result = 2;
    return alone;
}

/// The pixel at the origin, for texels outside every span.
template <class Pixel>
Pixel background_of(const TextureGraph& graph) {
    const GraphValues values(graph);
    GraphValues::Scratch scratch = values.make_scratch();
    return PixelEncoder<Pixel>()(values(Vec3d(0.0), scratch));
}

/// Colours a row of cached values, run by run.
template <class Pixel>
void color_row(const GraphValues& map, std::span<const TexelLayout::Run> runs,
               std::span<const double> values, GraphValues::Scratch& scratch,
               std::span<Pixel> row) {
    const BatchEncoder<Pixel> encode;
    for (const TexelLayout::Run& run : runs)
        for (std::size_t done = 0, count = 0; done < run.count; done += count) {
            count = std::min<std::size_t>(run.count - done, value_batch);
            std::copy_n(&values[run.x + done], count, scratch[0]);
            encode(map(count, scratch), count, &row[run.x + done]);
        }
}

}  // namespace

bool CachedGraph::splits(const TextureGraph& graph, const Filter& filter) {
    if (filter.kind != FilterKind::none || graph.nodes.size() < 3) return false;
    if (!graph.channels.empty() || graph.result != graph.nodes.size() - 1) return false;
    const GraphNode& last = graph.nodes.back();
    if (type_of(last).name != "color_map" || last.inputs.front() != graph.nodes.size() - 2)
        return false;
    // The map's texture must have no other user.
    return std::ranges::count(graph.nodes, last.texture, &GraphNode::texture) == 1;
}

template <class Pixel>
void CachedGraph::synthesize(const TextureGraph& graph, const Affine3& texture_from_atlas,
                             int threads, Image<Pixel>& image, const Economy& economy,
                             const MaskImages& masks) {
    check_masks(graph, GraphOutput::color, masks, solid_->size);
    const std::size_t size = solid_->size;
    if (budget_ / sizeof(double) < size * size) {
        image = synthesize_graph<Pixel>(*solid_, graph, texture_from_atlas, {}, threads,
                                        PrecisionKind::float32, economy, {}, masks);
        return;
    }
    const Key key{number_below(graph), texture_from_atlas, masks};
    SynthesisWork work;
    if (known_ == key) {
        work.texels = rows_.texels();
        work.skip_octaves(Skip::kept_terms, octaves_ * rows_.texels());
        work.skip_texels(Skip::unread_texels, std::uint64_t(size) * size - rows_.texels());
    } else {
        known_.reset();
        if (values_.width() != size) values_ = Image<double>::unset(size, size);
        const GraphValues number(key.graph);
        octaves_ = number.program().octaves();
        fill_points(*solid_, texture_from_atlas, number, {}, threads,
                    {economy.skips, &work, economy.stop, economy.meter}, RowBand(values_), masks);
        if (economy.stop.stop_requested()) return;
        known_ = key;
    }
    image = Image<Pixel>(size, size, background_of<Pixel>(graph));
    const GraphValues map(map_alone(graph));
    const auto color_rows = [&](const RowRange& range) {
        GraphValues::Scratch scratch = map.make_scratch();
        for (std::size_t y = range.begin(); y != range.end(); ++y)
            color_row<Pixel>(map, rows_.runs(y), values_.row(y), scratch, image.row(y));
    };
    for_row_ranges(size, 16 * value_batch, threads, color_rows, economy.stop);
    if (economy.work) *economy.work += work;
}

template void CachedGraph::synthesize(const TextureGraph&, const Affine3&, int, Image<Rgb8>&,
                                      const Economy&, const MaskImages&);
template void CachedGraph::synthesize(const TextureGraph&, const Affine3&, int, Image<Rgb16>&,
                                      const Economy&, const MaskImages&);
template void CachedGraph::synthesize(const TextureGraph&, const Affine3&, int, Image<RgbF>&,
                                      const Economy&, const MaskImages&);

}  // namespace burl
