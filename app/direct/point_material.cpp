#include "app/direct/point_material.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include "atlas/base/error.h"
#include "procedural/color/srgb.h"
#include "procedural/graph/evaluator.h"
#include "procedural/graph/masks.h"

namespace burl {

namespace {

double share(double number) {
    return std::clamp(number, 0.0, 1.0);
}

/// The base colour of a premultiplied one.
Vec3d base_of(const Vec4d& shown) {
    return shown.w > 0.0 ? glm::clamp(Vec3d(shown) / shown.w, 0.0, 1.0) : Vec3d(0.0);
}

/// The numbers of the material where no channel varies.
ShadedPoint constant_point(const Material& m) {
    ShadedPoint point;
    point.metallic = m.metallic;
    point.roughness = m.roughness;
    point.occlusion = m.occlusion;
    point.emissive = m.emissive_strength * linear_light(m.emissive);
    point.ior = m.ior;
    point.specular = m.specular;
    point.clearcoat = m.clearcoat;
    point.clearcoat_roughness = m.clearcoat_roughness;
    point.sheen = linear_light(m.sheen);
    point.sheen_roughness = m.sheen_roughness;
    point.transmission = m.transmission;
    return point;
}

/// The number of a shaded point that a channel is; none for colours and opacity.
double* number_of(ShadedPoint& point, Channel channel) {
    switch (channel) {
        case Channel::metallic:
            return &point.metallic;
        case Channel::roughness:
            return &point.roughness;
        case Channel::occlusion:
            return &point.occlusion;
        case Channel::specular:
            return &point.specular;
        case Channel::clearcoat:
            return &point.clearcoat;
        case Channel::clearcoat_roughness:
            return &point.clearcoat_roughness;
        case Channel::sheen_roughness:
            return &point.sheen_roughness;
        case Channel::transmission:
            return &point.transmission;
        case Channel::opacity:
        case Channel::emissive:
        case Channel::sheen:
            return nullptr;
    }
    return nullptr;
}

/// All planes of a material (procedural/graph/planes.h) at one point, in float64.
class PlaneSampler {
  public:
    PlaneSampler(const Recipe& recipe, FilterKind kind)
        : filtered_(kind != FilterKind::none),
          layout_(recipe.texture),
          evaluate_(recipe.texture, {kind, recipe.filter.samples, recipe.filter.band_limit},
                    PrecisionKind::float64, GraphOutput::planes),
          threads_([this] {
              return Thread{evaluate_.make_scratch(), layout_.count()};
          }) {}

    const PlaneLayout& layout() const { return layout_; }

    /// The planes' numbers, valid until the thread's next call.
    const std::vector<double>& operator()(const Vec3d& s, const Footprint& footprint) {
        Thread& thread = threads_.local();
        const Footprint used = filtered_ ? footprint : Footprint{};
        evaluate_.planes({&s, 1}, {&used, 1}, thread.scratch, thread.places);
        return thread.numbers;
    }

  private:
    struct Thread {
        Thread(GraphEvaluator::Scratch made, std::size_t count)
            : scratch(std::move(made)), numbers(count), places(count) {
            for (std::size_t p = 0; p < count; ++p) places[p] = &numbers[p];
        }
        Thread(const Thread& other) : Thread(other.scratch, other.numbers.size()) {}
        Thread& operator=(const Thread&) = delete;

        GraphEvaluator::Scratch scratch;
        std::vector<double> numbers;
        std::vector<double*> places;
    };

    bool filtered_;
    PlaneLayout layout_;
    GraphEvaluator evaluate_;
    tbb::enumerable_thread_specific<Thread> threads_;
};

/// A material whose channels vary.
class VaryingMaterial {
  public:
    VaryingMaterial(const Recipe& recipe, FilterKind kind)
        : material_(recipe.material),
          constant_(constant_point(recipe.material)),
          planes_(std::make_shared<PlaneSampler>(recipe, kind)) {
        for (const GraphChannel& one : recipe.texture.channels) channels_.push_back(one.channel);
    }

    MaterialSample operator()(const Vec3d& s, const Footprint& footprint) const {
        const std::vector<double>& numbers = (*planes_)(s, footprint);
        const PlaneLayout& layout = planes_->layout();
        MaterialSample sample{constant_};
        double opacity = material_.opacity;
        for (const Channel channel : channels_) {
            const double* at = &numbers[*layout.of(channel)];
            if (double* number = number_of(sample.point, channel)) *number = share(*at);
            if (channel == Channel::opacity) opacity *= share(*at);
            if (channel == Channel::sheen)
                sample.point.sheen = glm::clamp(Vec3d(at[0], at[1], at[2]), 0.0, 1.0);
            if (channel == Channel::emissive)
                sample.point.emissive =
                    material_.emissive_strength * glm::max(Vec3d(at[0], at[1], at[2]), 0.0);
        }
        const double alpha = layout.alpha() ? numbers[*layout.alpha()] : 1.0;
        const Vec4d color(numbers[0], numbers[1], numbers[2], alpha);
        const Vec4d shown = shown_color(material_, color, share(opacity));
        sample.point.base = base_of(shown);
        sample.alpha = shown.w;
        return sample;
    }

  private:
    Material material_;
    ShadedPoint constant_;
    std::vector<Channel> channels_;
    std::shared_ptr<PlaneSampler> planes_;
};

void check_masks(const TextureGraph& graph) {
    const std::string node = first_mask_node(graph, GraphOutput::planes);
    if (!node.empty())
        throw Error(ExitCode::unsupported,
                    fmt::format("the recipe's material: {}; bake it, or draw it with --lazy",
                                no_texels_for(node)));
}

}  // namespace

PointMaterial point_material(const Recipe& recipe, FilterKind kind, FilteredColor color,
                             bool shows_color) {
    check_masks(recipe.texture);
    if (!recipe.texture.channels.empty() && !shows_color) return VaryingMaterial(recipe, kind);
    return [color = std::move(color), constant = constant_point(recipe.material)](
               const Vec3d& s, const Footprint& footprint) {
        const Vec4d shown = color(s, footprint);
        MaterialSample sample{constant, shown.w};
        sample.point.base = base_of(shown);
        return sample;
    };
}

}  // namespace burl
