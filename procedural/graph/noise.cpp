// The nodes of irregular textures: the field of the 1999 model, and those of pbrt after Chuang's
// slides (2008). Octaves that a sample cannot show fade out by pbrt's rule.
#include "procedural/color/marble_spline.h"
#include "procedural/graph/box_means.h"
#include "procedural/graph/node_noise.h"
#include "procedural/graph/nodes.h"
#include "procedural/model/band_limit.h"
#include "procedural/noise/mean_noise.h"

namespace burl::nodes {

namespace {

using Sample = NoiseSample<double, 3>;

/// n(p) with its slope by the chain rule.
Dual noise_at(const NoiseSpec& noise, const DualPoint& p) {
    const Sample n = sample_noise<double, 3>(noise, {p.x.value, p.y.value, p.z.value});
    return {n.value,
            n.gradient[0] * p.x.slope + n.gradient[1] * p.y.slope + n.gradient[2] * p.z.slope};
}

DualPoint scaled(double factor, const DualPoint& p) {
    return {factor * p.x, factor * p.y, factor * p.z};
}

/// The sum sum_k gain^k n_{seed+k}(lacunarity^k p), with |n| for n if `absolute`.
struct OctaveSum {
    NoiseSpec noise;
    double octaves = 1.0, lacunarity = 2.0, gain = 0.5;
    bool absolute = false;

    static OctaveSum of(const NodeCall& call, bool absolute_values) {
        return {noise_of(call), call.parameter("octaves"), call.parameter("lacunarity"),
                call.parameter("gain"), absolute_values};
    }

    /// The mean of n or |n|, which replaces an octave that does not show.
    double mean() const {
        return absolute ? mean_absolute(noise.kind, noise.time.has_value())
                        : mean_value(noise.kind, noise.time.has_value());
    }

    /// The number of octaves that a sample shows whose point moves by `step`: pbrt's n = clamp(-1 -
    /// log2(step^2) / 2, 0, octaves), for any lacunarity. Octave k shows while the sample covers
    /// less than half a cell of it.
    double visible(double step) const {
        const double grows = std::log2(lacunarity);
        if (!(step > 0.0) || !(grows > 0.0)) return octaves;
        return std::clamp((-1.0 - binary_log(step)) / grows, 0.0, octaves);
    }

    /// The sum at p in a sample across which p moves by `step`. The last visible octave fades by
    /// smoothstep(0.3, 0.7); the faded part of |n| is replaced by its mean.
    Dual operator()(const DualPoint& p, double step) const {
        const double kept = visible(step);
        Dual sum;
        double weight = 1.0, frequency = 1.0;
        NoiseSpec octave = noise;
        for (double k = 0.0; k < octaves; ++k, ++octave.seed) {
            const double fade = dual_smoothstep(0.3, 0.7, std::min(kept - k, 1.0)).value;
            if (fade > 0.0) {
                const Dual n = noise_at(octave, scaled(frequency, p));
                sum = sum + weight * fade * (absolute ? dual_abs(n) : n);
            }
            if (fade < 1.0) sum = sum + weight * (1.0 - fade) * mean();
            weight *= gain;
            frequency *= lacunarity;
        }
        return sum;
    }
};

/// The move of the point for a step in the solid.
Vec3d moved_along(const DualPoint& p, const Vec3d& step) {
    return {glm::dot(p.x.slope, step), glm::dot(p.y.slope, step), glm::dot(p.z.slope, step)};
}

/// The length of the longer of the point's two moves across sample i.
double step_of(const NodeCall& call, const DualPoint& p, std::size_t i) {
    return std::max(glm::length(moved_along(p, call.footprints[i].u)),
                    glm::length(moved_along(p, call.footprints[i].v)));
}

/// Values and gradients of float32 sums at all points of a batch.
struct SlopeBatch32 {
    alignas(64) float value[graph_batch_size];
    alignas(64) float slope[3][graph_batch_size];

    SlopeArrays arrays() { return {value, {slope[0], slope[1], slope[2]}}; }
    /// The sum at p, point i of the batch.
    Dual at(std::size_t i, const DualPoint& p) const {
        return {double(value[i]), double(slope[0][i]) * p.x.slope +
                                      double(slope[1][i]) * p.y.slope +
                                      double(slope[2][i]) * p.z.slope};
    }
};

/// A sum of octaves at `scale` times a batch's points: point by point in float64, or for the whole
/// batch in float32.
class PointSums {
  public:
    PointSums(const NodeCall& call, const OctaveSum& sum, const Vec3d& scale = Vec3d(1.0),
              bool fades = true)
        : call_(call), sum_(sum), scale_(scale), fades_(fades) {
        if (call.float32) add_up_batch();
    }

    Dual operator()(std::size_t i) const {
        const DualPoint p = point(i);
        if (call_.float32) return batch_.at(i, p);
        return sum_(p, fades_ ? step_of(call_, p, i) : 0.0);
    }

  private:
    DualPoint point(std::size_t i) const {
        const DualPoint p = call_.point(i);
        return {scale_.x * p.x, scale_.y * p.y, scale_.z * p.z};
    }

    NoiseSum octaves() const {
        NoiseSum sum{sum_.noise, sum_.absolute ? OctaveShape::absolute : OctaveShape::plain, {}, 0};
        double frequency = 1.0, weight = 1.0;
        for (double k = 0.0; k < sum_.octaves; ++k) {
            sum.octaves.push_back({sum_.noise.seed + std::uint32_t(k), frequency, weight});
            weight *= sum_.gain;
            frequency *= sum_.lacunarity;
        }
        return sum;
    }

    void add_up_batch() {
        alignas(64) double points[3][graph_batch_size];
        alignas(64) float kept[graph_batch_size];
        bool all = true;
        for (std::size_t i = 0; i < call_.count(); ++i) {
            const DualPoint p = point(i);
            points[0][i] = p.x.value, points[1][i] = p.y.value, points[2][i] = p.z.value;
            const double visible = fades_ ? sum_.visible(step_of(call_, p, i)) : sum_.octaves;
            kept[i] = float(visible);
            all = all && visible >= sum_.octaves;
        }
        // The kernel reads whole vectors, so the elements up to the end of the last one are set.
        for (std::size_t i = call_.count(); i < graph_batch_size && i % batch_padding != 0; ++i)
            points[0][i] = points[1][i] = points[2][i] = 0.0, kept[i] = 0.0f;
        add_up_slopes(octaves(), {points[0], points[1], points[2]}, call_.count(),
                      {all ? nullptr : kept, sum_.mean()}, batch_.arrays());
    }

    const NodeCall& call_;
    const OctaveSum& sum_;
    Vec3d scale_;
    bool fades_;
    SlopeBatch32 batch_;
};

/// The quadric and its gradient at p.
FieldSample quadric_at(const Quadric& quadric, const DualPoint& p) {
    return sample_field<double>(quadric, {}, {p.x.value, p.y.value, p.z.value});
}

/// A field's values at a batch's points, and gradients with respect to the points, with sums of
/// noise in float32.
std::vector<FieldSample> field_sums(const NodeCall& call) {
    std::vector<FieldSample> fields(call.count());
    for (const auto& [lattice, sum] : call.prepared->sums) {
        alignas(64) double points[3][graph_batch_size] = {};
        for (std::size_t i = 0; i < call.count(); ++i) {
            const Vec3d p =
                lattice({call.place[0].value[i], call.place[1].value[i], call.place[2].value[i]});
            for (int axis = 0; axis < 3; ++axis) points[axis][i] = p[axis];
        }
        SlopeBatch32 batch;
        add_up_slopes(sum, {points[0], points[1], points[2]}, call.count(), {}, batch.arrays());
        for (std::size_t i = 0; i < call.count(); ++i) {
            const Vec3d slope(batch.slope[0][i], batch.slope[1][i], batch.slope[2][i]);
            fields[i].value += double(batch.value[i]);
            // Gradients go back by the transposed map.
            fields[i].gradient += slope * lattice.linear;
        }
    }
    double offsets = 0.0;
    for (const Octave& octave : call.prepared->octaves) offsets += octave.offset;
    const Quadric& quadric = call.graph->textures[call.node->texture].quadric;
    for (std::size_t i = 0; i < call.count(); ++i) {
        const FieldSample q = quadric_at(quadric, call.point(i));
        fields[i].value += q.value + offsets;
        fields[i].gradient += q.gradient;
    }
    return fields;
}

/// The field at p without the octaves that sample i cannot show, whose means replace them.
FieldSample faded_field(const NodeCall& call, const Quadric& quadric, const DualPoint& p,
                        std::size_t i) {
    const Vec3d s(p.x.value, p.y.value, p.z.value);
    const Vec3d u = moved_along(p, call.footprints[i].u), v = moved_along(p, call.footprints[i].v);
    FieldSample f = sample_field<double>(quadric, {}, s);
    for (std::size_t k = 0; k < call.prepared->octaves.size(); ++k) {
        const Octave& octave = call.prepared->octaves[k];
        const Mat3d& lattice = octave.lattice_from_solid.linear;
        const double weight = band_weight(lattice * u, lattice * v);
        const FieldSample n = sample_field<double>({}, {&octave, 1}, s);
        f.value += weight * (n.value - octave.offset) + octave.offset +
                   (1.0 - weight) * call.prepared->means[k];
        f.gradient += weight * n.gradient;
    }
    return f;
}

/// The weights of four neighbouring control points at u in [0, 1]: Bernstein's (pbrt's, whose
/// spline jumps from one four points to the next) or those of the uniform cubic B-spline (`smooth`,
/// without jumps).
std::array<Dual, 4> spline_weights(bool smooth, const Dual& u) {
    const Dual v = 1.0 - u;
    if (!smooth) return {v * v * v, 3.0 * u * v * v, 3.0 * u * u * v, u * u * u};
    const Dual a = v * v * v, d = u * u * u;
    const Dual b = 4.0 - 6.0 * u * u + 3.0 * d, c = 4.0 - 6.0 * v * v + 3.0 * a;
    return {1.0 / 6.0 * a, 1.0 / 6.0 * b, 1.0 / 6.0 * c, 1.0 / 6.0 * d};
}

/// The colour of the marble spline at t in [0, 1].
std::array<Dual, 3> marble_color(bool smooth, const Dual& t) {
    constexpr double segments = double(marble_segments);
    const double first = std::clamp(std::floor(t.value * segments), 0.0, segments - 1.0);
    const auto weights = spline_weights(smooth, segments * t - first);
    std::array<Dual, 3> color;
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t k = 0; k < 4; ++k)
            color[c] = color[c] +
                       marble_brightness * marble_colors[std::size_t(first) + k][c] * weights[k];
    return color;
}

}  // namespace

void field(const NodeCall& call) {
    const Quadric& quadric = call.graph->textures[call.node->texture].quadric;
    const bool fades = !call.prepared->means.empty();
    std::vector<FieldSample> sums;
    if (call.float32 && !fades) sums = field_sums(call);
    for_each_point(call, [&](std::size_t i) {
        const DualPoint p = call.point(i);
        const Vec3d s(p.x.value, p.y.value, p.z.value);
        const FieldSample f = fades ? faded_field(call, quadric, p, i)
                              : !sums.empty()
                                  ? sums[i]
                                  : sample_field<double>(quadric, call.prepared->octaves, s);
        return Dual(f.value,
                    f.gradient.x * p.x.slope + f.gradient.y * p.y.slope + f.gradient.z * p.z.slope);
    });
}

void fbm(const NodeCall& call) {
    const OctaveSum octaves = OctaveSum::of(call, false);
    for_each_point(call, PointSums(call, octaves));
}

void wrinkled(const NodeCall& call) {
    const OctaveSum octaves = OctaveSum::of(call, true);
    for_each_point(call, PointSums(call, octaves));
}

void windy(const NodeCall& call) {
    const OctaveSum octaves = OctaveSum::of(call, false);
    OctaveSum slow = octaves;
    slow.octaves = 3.0;
    const PointSums waves(call, octaves), wind(call, slow, Vec3d(0.1));
    for_each_point(call, [&](std::size_t i) { return dual_abs(wind(i)) * waves(i); });
}

void marble(const NodeCall& call) {
    const OctaveSum octaves = OctaveSum::of(call, false);
    const double scale = call.parameter("scale"), variation = call.parameter("variation");
    const PointSums sum(call, octaves, Vec3d(scale));
    const bool smooth = call.parameter("spline") == 1.0;
    for (std::size_t i = 0; i < call.count(); ++i) {
        const Dual vein = scale * call.point(i).y + variation * sum(i);
        const auto color = marble_color(smooth, 0.5 + 0.5 * dual_sin(vein));
        for (std::size_t c = 0; c < 3; ++c) call.out[c].set(i, color[c]);
        call.out[3].set(i, 1.0);
    }
}

void bumps(const NodeCall& call) {
    const OctaveSum octave{noise_of(call), 1.0};
    const PointSums noise(call, octave, call.vector("frequency"), false);
    const double threshold = call.parameter("threshold");
    blend_inputs(call, [&](std::size_t i) {
        const Dual n = noise(i);
        const Dual above = (is_distance(octave.noise.kind) ? n : 0.5 + 0.5 * n) - threshold;
        return box_step(above, call.box_width(above, i));
    });
}

void dots(const NodeCall& call) {
    NoiseSpec noise;
    noise.kind = NoiseKind::cell;
    noise.seed = std::uint32_t(call.parameter("seed"));
    noise.period = {std::uint32_t(call.parameter("period_u")),
                    std::uint32_t(call.parameter("period_v"))};
    const double radius = call.parameter("radius"), shift = 0.5 - radius;
    blend_inputs(call, [&](std::size_t i) -> Dual {
        const DualPoint p = call.point(i);
        const double s = std::floor(p.x.value + 0.5), t = std::floor(p.y.value + 0.5);
        const auto random = [&](double u, double v) {
            return shift * sample_noise<double, 3>(noise, {s + u, t + v, 0.5}).value;
        };
        if (!(random(0.5, 0.5) >= 0.0)) return 0.0;
        const Dual away = dual_length(p.x - (s + random(1.5, 2.8)), p.y - (t + random(4.5, 9.8)));
        const Dual inside = radius - away;
        return box_step(inside, call.box_width(inside, i));
    });
}

void warp(const NodeCall& call) {
    const double strength = call.parameter("strength");
    std::array<OctaveSum, 3> octaves;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        octaves[axis] = OctaveSum::of(call, false);
        octaves[axis].noise.seed += std::uint32_t(axis) << 16;
    }
    const PointSums x(call, octaves[0]), y(call, octaves[1]), z(call, octaves[2]);
    map_points(call, [&](std::size_t i, const DualPoint& p) -> DualPoint {
        return {p.x + strength * x(i), p.y + strength * y(i), p.z + strength * z(i)};
    });
}

}  // namespace burl::nodes
