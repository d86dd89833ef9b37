#include "app/pipeline/texture_color.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include "app/pipeline/material.h"
#include "atlas/base/error.h"
#include "procedural/color/filtered_colors.h"
#include "procedural/color/srgb.h"
#include "procedural/fixed/field.h"
#include "procedural/graph/evaluator.h"
#include "procedural/graph/masks.h"
#include "procedural/graph/values.h"
#include "procedural/model/octaves.h"

namespace burl {

namespace {

/// A texture graph in float64 with gradients. Every thread has scratch arrays, which are too large
/// to be allocated for every point.
class GraphSampler {
  public:
    /// Takes the graph, and a filter as GraphEvaluator does.
    explicit GraphSampler(const TextureGraph& graph, const Filter& filter = {FilterKind::trapezoid})
        : evaluate_(graph, filter), scratch_([this] { return evaluate_.make_scratch(); }) {}

    /// The graph's value at s, filtered over the footprint; a footprint of 0 gives the unfiltered
    /// value. May be called from several threads at once.
    GraphSample operator()(const Vec3d& s, const Footprint& footprint = {}) {
        GraphSample sample;
        evaluate_({&s, 1}, {&footprint, 1}, scratch_.local(), {&sample, 1});
        return sample;
    }

  private:
    GraphEvaluator evaluate_;
    tbb::enumerable_thread_specific<GraphEvaluator::Scratch> scratch_;
};

/// A texture graph in float32, unfiltered, as colours in linear light. Every thread has scratch
/// arrays.
class GraphColorSampler {
  public:
    explicit GraphColorSampler(const TextureGraph& graph)
        : values_(graph), scratch_([this] { return values_.make_scratch(); }) {}

    /// The colour at s. May be called from several threads at once.
    Vec3d operator()(const Vec3d& s) { return values_(s, scratch_.local()); }

  private:
    GraphValues values_;
    tbb::enumerable_thread_specific<GraphValues::Scratch> scratch_;
};

/// Linear light multiplied by alpha, and alpha; numbers have alpha 1.
Vec4d color_and_alpha(const GraphSample& sample) {
    return {sample.color(), sample.wire == Wire::number ? 1.0 : sample.channels[3].value};
}

/// A number at texture coordinates, over a footprint.
using FilteredNumber = std::function<double(const Vec3d& s, const Footprint& footprint)>;

/// The recipe's opacity, a number or a channel of its graph, in [0, 1].
FilteredNumber opacity_at(const Recipe& recipe, FilterKind kind) {
    TextureGraph graph = recipe.texture;
    const auto channel =
        std::ranges::find(graph.channels, Channel::opacity, &GraphChannel::channel);
    const double factor = recipe.material.opacity;
    if (channel == graph.channels.end())
        return [factor](const Vec3d&, const Footprint&) { return factor; };
    graph.result = channel->node;
    graph.channels.clear();
    check_points(graph, "material.opacity");
    const Filter filter{kind, recipe.filter.samples, recipe.filter.band_limit};
    const auto number = std::make_shared<GraphSampler>(graph, filter);
    const bool filtered = kind != FilterKind::none;
    return [number, filtered, factor](const Vec3d& s, const Footprint& footprint) {
        const GraphSample sample = (*number)(s, filtered ? footprint : Footprint{});
        return std::clamp(factor * sample.channels[0].value, 0.0, 1.0);
    };
}

/// The 1999 model in fixed point with its colour map filtered, as the paper's simulator had both.
/// The colour table has the map's own precision.
FilteredColor fixed_and_filtered(const Texture& texture, const FixedFormat& format,
                                 FilterKind kind) {
    return [field = FixedField(texture, format), colors = FilteredColors(texture.colors, kind)](
               const Vec3d& s, const Footprint& footprint) {
        const auto [f, u, v] = spread_over(field, s, footprint);
        return Vec4d(colors(f, u, v), 1.0);
    };
}

/// The colour without its alpha from `cutoff` on, and nothing below.
Vec4d masked(const Vec4d& color, double cutoff) {
    if (color.w < cutoff) return Vec4d(0.0);
    return {Vec3d(color) / (color.w > 0.0 ? color.w : 1.0), 1.0};
}

}  // namespace

void check_points(const TextureGraph& graph, const std::string& path) {
    const std::string node = first_mask_node(graph, GraphOutput::color);
    if (!node.empty())
        throw Error(ExitCode::unsupported,
                    fmt::format("{}: {}; bake it", path, no_texels_for(node)));
}

FilteredColor filtered_color(const Recipe& recipe, FilterKind kind) {
    check_points(recipe.texture, "texture");
    if (kind == FilterKind::none && plain_texture(recipe.texture)) {
        return [color = texture_color(recipe, recipe.precision)](const Vec3d& s, const Footprint&) {
            return Vec4d(color(s), 1.0);
        };
    }
    if (kind != FilterKind::none && recipe.precision.kind == PrecisionKind::fixed) {
        const Texture* texture = plain_texture(recipe.texture);
        if (!texture)
            throw Error(ExitCode::usage,
                        "fixed point has a color_map over a field alone; draw it in float64");
        return fixed_and_filtered(*texture, recipe.precision.format, kind);
    }
    const Filter filter{kind, recipe.filter.samples, recipe.filter.band_limit};
    const auto graph = std::make_shared<GraphSampler>(recipe.texture, filter);
    const bool filtered = kind != FilterKind::none;
    return [graph, filtered](const Vec3d& s, const Footprint& footprint) {
        return color_and_alpha((*graph)(s, filtered ? footprint : Footprint{}));
    };
}

Vec4d shown_color(const Material& material, const Vec4d& color, double opacity) {
    if (material.alpha == AlphaMode::opaque) return {Vec3d(color), 1.0};
    const Vec4d shown = opacity * color;
    return material.alpha == AlphaMode::mask ? masked(shown, material.alpha_cutoff) : shown;
}

FilteredColor shown_color(const Recipe& recipe, FilterKind kind) {
    FilteredColor color = filtered_color(recipe, kind);
    const Material& material = recipe.material;
    if (material.alpha == AlphaMode::opaque)
        return [color = std::move(color)](const Vec3d& s, const Footprint& footprint) {
            return Vec4d(Vec3d(color(s, footprint)), 1.0);
        };
    if (!is_transparent(recipe)) return color;
    return [color = std::move(color), opacity = opacity_at(recipe, kind), material](
               const Vec3d& s, const Footprint& footprint) {
        return shown_color(material, color(s, footprint), opacity(s, footprint));
    };
}

FilteredColor filter_width_grey(const Recipe& recipe) {
    const Texture* texture = plain_texture(recipe.texture);
    if (!texture)
        throw Error(ExitCode::usage,
                    fmt::format("--widths: the texture of '{}' is a graph, which has no single "
                                "filter width; use a recipe that is an opaque color_map of a "
                                "field",
                                recipe.name));
    return [octaves = expand_octaves(*texture), quadric = texture->quadric](
               const Vec3d& s, const Footprint& covered) {
        const Vec3d slope = sample_field<double>(quadric, octaves, s).gradient;
        const double width =
            256.0 * std::hypot(glm::dot(slope, covered.u), glm::dot(slope, covered.v));
        return Vec4d(Vec3d(srgb_decode((std::clamp(width, 1.0, 256.0) - 1.0) / 255.0)), 1.0);
    };
}

TextureColor texture_color(const Recipe& recipe, const Precision& precision) {
    check_points(recipe.texture, "texture");
    const Texture* texture = plain_texture(recipe.texture);
    if (!texture && precision.kind == PrecisionKind::float32)
        return [graph = std::make_shared<GraphColorSampler>(recipe.texture)](const Vec3d& s) {
            return (*graph)(s);
        };
    if (!texture) {
        return [graph = std::make_shared<GraphSampler>(recipe.texture)](const Vec3d& s) {
            return (*graph)(s).color();
        };
    }
    if (precision.kind == PrecisionKind::fixed)
        return [field = FixedField(*texture, precision.format), colors = texture->colors](
                   const Vec3d& s) { return evaluate_color(colors, field(s)); };
    if (precision.kind == PrecisionKind::float32)
        return [octaves = expand_octaves(*texture), quadric = texture->quadric,
                colors = texture->colors](const Vec3d& s) {
            return evaluate_color(colors, sample_field<float>(quadric, octaves, s).value);
        };
    return [octaves = expand_octaves(*texture), quadric = texture->quadric,
            colors = texture->colors](const Vec3d& s) {
        return evaluate_color(colors, evaluate_field(quadric, octaves, s));
    };
}

SurfaceNormal bumped_normals(const Recipe& recipe, const Mesh& mesh) {
    if (recipe.bump.empty()) return {};
    check_points(recipe.bump.input, "bump.input");
    const Affine3 map = texture_from_mesh(recipe, mesh);
    const double height = recipe.bump.height / solid_units(mesh, recipe.solid.space);
    return [graph = std::make_shared<GraphSampler>(recipe.bump.input), map, height](
               const Vec3d& point, const Vec3d& normal) {
        const Dual node = (*graph)(map(point)).channels[0];
        return bumped_normal(normal, height_gradient(node, height, map.linear));
    };
}

}  // namespace burl
