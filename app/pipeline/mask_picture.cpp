#include "app/pipeline/mask_picture.h"
#include "atlas/base/json.h"

#include "procedural/color/pixel_encoder.h"
#include "procedural/fill/graph.h"
#include "procedural/graph/json.h"

namespace burl {

namespace {

constexpr std::array<std::string_view, 8> pictured{"occlusion", "curvature",       "thickness",
                                                   "facing",    "height_in_box",   "edge_distance",
                                                   "part",      light_picture_name};

/// The number that a value of a mask has in a picture.
struct MaskRange {
    double factor = 1.0, offset = 0.0;
};

MaskRange range_of(const Pipeline& pipeline, const std::string& name) {
    if (name == "curvature" || name == "facing") return {0.5, 0.5};
    if (name != "thickness" && name != "edge_distance") return {};
    const Recipe& recipe = pipeline.recipe();
    const double diagonal = glm::length(bounding_box(pipeline.mesh()).size()) * recipe.solid.scale *
                            solid_units(pipeline.mesh(), recipe.solid.space);
    return {diagonal > 0.0 ? 1.0 / diagonal : 0.0, 0.0};
}

}  // namespace

std::span<const std::string_view> mask_picture_names() {
    return pictured;
}

template <class Code>
Image<Code> mask_picture(Pipeline& pipeline, const std::string& name) {
    const TextureGraph graph = graph_from_json({{"node", name}});
    const MaskImages mask = pipeline.masks()(pipeline.solid(), graph, GraphOutput::color, {});
    const auto [factor, offset] = range_of(pipeline, name);
    return converted<Code>(mask.front()->values, [=](float value) {
        return linear_code<Code>(factor * double(value) + offset);
    });
}

template <class Pixel>
Image<Pixel> light_picture(Pipeline& pipeline) {
    const TextureGraph graph = graph_from_json({{"node", light_picture_name}});
    const MaskImages masks = pipeline.masks()(pipeline.solid(), graph, GraphOutput::color, {});
    return synthesize_graph<Pixel>(pipeline.solid(), graph, {}, {}, pipeline.context().way.threads,
                                   PrecisionKind::float32, {}, {}, masks);
}

template Image<Rgb8> light_picture(Pipeline&);
template Image<Rgb16> light_picture(Pipeline&);
template Image<Grey8> mask_picture(Pipeline&, const std::string&);
template Image<Grey16> mask_picture(Pipeline&, const std::string&);

}  // namespace burl
