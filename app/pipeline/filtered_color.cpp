#include "app/pipeline/filtered_color.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/pipeline/graph_sampler.h"
#include "app/pipeline/texture_color.h"
#include "atlas/base/error.h"
#include "procedural/color/srgb.h"
#include "procedural/model/octaves.h"

namespace burl {

namespace {

/// Linear light multiplied by alpha, and alpha; numbers have alpha 1.
Vec4d color_and_alpha(const GraphSample& sample) {
    return {sample.color(), sample.wire == Wire::number ? 1.0 : sample.channels[3].value};
}

}  // namespace

FilteredColor filtered_color(const Recipe& recipe, FilterKind kind) {
    if (kind == FilterKind::none && plain_texture(recipe.texture)) {
        return [color = texture_color(recipe, recipe.precision)](const Vec3d& s, const Footprint&) {
            return Vec4d(color(s), 1.0);
        };
    }
    if (kind != FilterKind::none && recipe.precision.kind == PrecisionKind::fixed)
        throw Error(ExitCode::usage,
                    "fixed point has no gradients to filter by; draw it with --filter none");
    const Filter filter{kind, recipe.filter.samples, recipe.filter.band_limit};
    const auto graph = std::make_shared<GraphSampler>(recipe.texture, filter);
    const bool filtered = kind != FilterKind::none;
    return [graph, filtered](const Vec3d& s, const Footprint& footprint) {
        return color_and_alpha((*graph)(s, filtered ? footprint : Footprint{}));
    };
}

FilteredColor filter_width_grey(const Recipe& recipe) {
    const Texture* texture = plain_texture(recipe.texture);
    if (!texture)
        throw Error(ExitCode::usage,
                    fmt::format("--widths: the texture of '{}' is a graph, which has no single "
                                "filter width; use a recipe that is a color_map of a field",
                                recipe.name));
    return [octaves = expand_octaves(*texture), quadric = texture->quadric](
               const Vec3d& s, const Footprint& covered) {
        const Vec3d slope = sample_field<double>(quadric, octaves, s).gradient;
        const double width =
            256.0 * std::hypot(glm::dot(slope, covered.u), glm::dot(slope, covered.v));
        return Vec4d(Vec3d(srgb_decode((std::clamp(width, 1.0, 256.0) - 1.0) / 255.0)), 1.0);
    };
}

}  // namespace burl
