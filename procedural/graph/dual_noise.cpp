// The steps of noise with gradients. Octaves that a footprint does not show fade by pbrt's rule.
#include "procedural/field/lattice_sums.h"
#include "procedural/graph/box_means.h"
#include "procedural/graph/duals.h"
#include "procedural/model/band_limit.h"

namespace burl {

namespace {

/// The move of the point for a step in the solid.
Vec3d moved_along(const DualPoint& p, const Vec3d& step) {
    return {glm::dot(p.x.slope, step), glm::dot(p.y.slope, step), glm::dot(p.z.slope, step)};
}

/// The slope of a number from its derivatives with respect to the point's coordinates.
Vec3d slope_at(const DualPoint& p, double gx, double gy, double gz) {
    return gx * p.x.slope + gy * p.y.slope + gz * p.z.slope;
}

Dual noise_at(const NoiseSpec& noise, double frequency, const DualPoint& p) {
    const auto times = [&](const Dual& x) {
        return Dual(frequency * x.value, frequency * x.slope);
    };
    const DualPoint q{times(p.x), times(p.y), times(p.z)};
    const auto n = sample_noise<double, 3>(noise, {q.x.value, q.y.value, q.z.value});
    return {n.value, slope_at(q, n.gradient[0], n.gradient[1], n.gradient[2])};
}

/// Values and gradients of a sum in float32 at all points of a batch.
struct SlopeBatch32 {
    alignas(64) float value[graph_batch_size];
    alignas(64) float slope[3][graph_batch_size];

    SlopeArrays arrays() { return {value, {slope[0], slope[1], slope[2]}}; }
    /// The sum at point i, which is p.
    Dual at(std::size_t i, const DualPoint& p) const {
        return {double(value[i]),
                slope_at(p, double(slope[0][i]), double(slope[1][i]), double(slope[2][i]))};
    }
};

/// The function of a sum of octaves: point by point in float64, or over a batch in float32.
class DualOctaves {
  public:
    DualOctaves(const OctaveSum& octaves, bool float32)
        : octaves_(octaves), sum_(octaves.sum()), mean_(octaves.mean()), float32_(float32) {}

    void operator()(const DualCall& call) const {
        if (float32_) return add_up_batch(call);
        for (std::size_t i = 0; i < call.count(); ++i) {
            const DualPoint p = point(call, i);
            call.outputs[0]->set(i, sum_at(p, visible(call, p, i)));
        }
    }

  private:
    DualPoint point(const DualCall& call, std::size_t i) const {
        const auto scaled = [&](const Dual& x) {
            return Dual(octaves_.scale * x.value, octaves_.scale * x.slope);
        };
        const DualPoint p = call.point(i);
        return {scaled(p.x), scaled(p.y), scaled(p.z)};
    }

    /// The number of visible octaves, pbrt's n = clamp(-1 - log2(step^2) / 2, 0, octaves) for any
    /// lacunarity; `step` is the longer of the point's two moves across the footprint. Octave k is
    /// visible while the footprint covers less than half a cell of it.
    double visible(const DualCall& call, const DualPoint& p, std::size_t i) const {
        if (!octaves_.fades) return octaves_.octaves;
        const double step = std::max(glm::length(moved_along(p, call.footprints[i].u)),
                                     glm::length(moved_along(p, call.footprints[i].v)));
        const double grows = std::log2(octaves_.lacunarity);
        if (!(step > 0.0) || !(grows > 0.0)) return octaves_.octaves;
        return std::clamp((-1.0 - binary_log(step)) / grows, 0.0, octaves_.octaves);
    }

    /// The sum at p, whose last visible octave fades by smoothstep(0.3, 0.7). The mean replaces
    /// what has faded.
    Dual sum_at(const DualPoint& p, double kept) const {
        Dual total;
        NoiseSpec noise = octaves_.noise;
        for (std::size_t k = 0; k < sum_.octaves.size(); ++k) {
            const SumOctave& octave = sum_.octaves[k];
            noise.seed = octave.seed;
            const double fade = dual_smoothstep(0.3, 0.7, std::min(kept - double(k), 1.0)).value;
            if (fade > 0.0) {
                const Dual n = noise_at(noise, octave.frequency, p);
                const Dual shown = octaves_.shape == OctaveShape::absolute ? dual_abs(n) : n;
                total = total + octave.weight * fade * shown;
            }
            if (fade < 1.0) total = total + octave.weight * (1.0 - fade) * mean_;
        }
        return total;
    }

    void add_up_batch(const DualCall& call) const {
        alignas(64) double points[3][graph_batch_size];
        alignas(64) float kept[graph_batch_size];
        bool all = true;
        for (std::size_t i = 0; i < call.count(); ++i) {
            const DualPoint p = point(call, i);
            points[0][i] = p.x.value, points[1][i] = p.y.value, points[2][i] = p.z.value;
            const double shown = visible(call, p, i);
            kept[i] = float(shown);
            all = all && shown >= octaves_.octaves;
        }
        // Whole vectors are read, and what lies behind the points does not count.
        for (std::size_t i = call.count(); i < graph_batch_size && i % batch_padding != 0; ++i)
            points[0][i] = points[1][i] = points[2][i] = 0.0, kept[i] = 0.0f;
        SlopeBatch32 batch;
        add_up_slopes(sum_, {points[0], points[1], points[2]}, call.count(),
                      {all ? nullptr : kept, mean_}, batch.arrays());
        for (std::size_t i = 0; i < call.count(); ++i)
            call.outputs[0]->set(i, batch.at(i, point(call, i)));
    }

    OctaveSum octaves_;
    NoiseSum sum_;
    double mean_;
    bool float32_;
};

/// The function of a texture's field: octaves in float64, or in float32 where none fades.
class DualField {
  public:
    DualField(const Texture& texture, const DualSettings& settings)
        : quadric_(texture.quadric), octaves_(expand_octaves(texture)) {
        for (const Octave& octave : octaves_) offsets_ += octave.offset;
        if (settings.filter.band_limit)
            for (const Octave& octave : octaves_) means_.push_back(octave_mean(octave));
        else if (settings.float32)
            sums_ = lattice_sums(octaves_);
    }

    void operator()(const DualCall& call) const {
        std::vector<FieldSample> sums;
        if (!sums_.empty()) sums = add_up_batch(call);
        for (std::size_t i = 0; i < call.count(); ++i) {
            const DualPoint p = call.point(i);
            const Vec3d s(p.x.value, p.y.value, p.z.value);
            const FieldSample f = !means_.empty() ? faded(call, p, i)
                                  : !sums.empty() ? sums[i]
                                                  : sample_field<double>(quadric_, octaves_, s);
            call.outputs[0]->set(i,
                                 {f.value, slope_at(p, f.gradient.x, f.gradient.y, f.gradient.z)});
        }
    }

  private:
    /// The field over a batch, octaves in float32, with gradients by the points' coordinates.
    std::vector<FieldSample> add_up_batch(const DualCall& call) const {
        std::vector<FieldSample> fields(call.count());
        const auto solid = [&](std::size_t i) {
            return Vec3d(call.inputs[0]->value[i], call.inputs[1]->value[i],
                         call.inputs[2]->value[i]);
        };
        for (const auto& [lattice, sum] : sums_) {
            alignas(64) double points[3][graph_batch_size] = {};
            for (std::size_t i = 0; i < call.count(); ++i) {
                const Vec3d p = lattice(solid(i));
                for (int axis = 0; axis < 3; ++axis) points[axis][i] = p[axis];
            }
            SlopeBatch32 batch;
            add_up_slopes(sum, {points[0], points[1], points[2]}, call.count(), {}, batch.arrays());
            for (std::size_t i = 0; i < call.count(); ++i) {
                const Vec3d slope(batch.slope[0][i], batch.slope[1][i], batch.slope[2][i]);
                fields[i].value += double(batch.value[i]);
                fields[i].gradient += slope * lattice.linear;  // the transposed map
            }
        }
        for (std::size_t i = 0; i < call.count(); ++i) {
            const FieldSample q = sample_field<double>(quadric_, {}, solid(i));
            fields[i].value += q.value + offsets_;
            fields[i].gradient += q.gradient;
        }
        return fields;
    }

    /// The field at p, where means replace the octaves that the footprint does not show.
    FieldSample faded(const DualCall& call, const DualPoint& p, std::size_t i) const {
        const Vec3d s(p.x.value, p.y.value, p.z.value);
        const Vec3d u = moved_along(p, call.footprints[i].u),
                    v = moved_along(p, call.footprints[i].v);
        FieldSample f = sample_field<double>(quadric_, {}, s);
        for (std::size_t k = 0; k < octaves_.size(); ++k) {
            const Octave& octave = octaves_[k];
            const Mat3d& lattice = octave.lattice_from_solid.linear;
            const double weight = band_weight(lattice * u, lattice * v);
            const FieldSample n = sample_field<double>({}, {&octave, 1}, s);
            f.value +=
                weight * (n.value - octave.offset) + octave.offset + (1.0 - weight) * means_[k];
            f.gradient += weight * n.gradient;
        }
        return f;
    }

    Quadric quadric_;
    std::vector<Octave> octaves_;
    double offsets_ = 0.0;
    std::vector<double> means_;     ///< mean of each octave; empty where none fades
    std::vector<LatticeSum> sums_;  ///< octaves as sums in float32; empty in float64
};

}  // namespace

DualFunction dual_function(const OctaveSum& work, const DualSettings& settings) {
    return DualOctaves(work, settings.float32);
}

DualFunction dual_function(const FieldAt& work, const DualSettings& settings) {
    return DualField(*work.texture, settings);
}

DualFunction dual_function(const DotsWeight& work, const DualSettings&) {
    NoiseSpec noise;
    noise.kind = NoiseKind::cell;
    noise.seed = work.seed;
    noise.period = {work.period_u, work.period_v};
    return for_each_point([noise, radius = work.radius](const DualCall& call, std::size_t i) {
        const Dual x = call.in(0, i), y = call.in(1, i);
        const double s = std::floor(x.value + 0.5), t = std::floor(y.value + 0.5);
        const auto random = [&](double u, double v) {
            return (0.5 - radius) * sample_noise<double, 3>(noise, {s + u, t + v, 0.5}).value;
        };
        if (!(random(0.5, 0.5) >= 0.0)) return Dual(0.0);
        const Dual away = dual_length(x - (s + random(1.5, 2.8)), y - (t + random(4.5, 9.8)));
        const Dual inside = radius - away;
        return box_step(inside, call.box_width(inside, i));
    });
}

}  // namespace burl
