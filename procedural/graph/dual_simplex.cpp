// The steps of simplex noises with gradients. An octave fades where the footprint covers more than
// half a cell of it, by pbrt's rule; its mean is 0.
#include "procedural/graph/duals.h"
#include "procedural/noise/simplex_curl.h"

namespace burl {

namespace {

constexpr std::size_t most = most_simplex_dimensions;

/// The coordinates that an octave is evaluated at, of which the first `count` are used.
struct OctavePoint {
    std::array<Dual, most> x{};
    std::size_t count = 0;

    /// The point of octave frequency: the first three inputs times the frequency, the others as
    /// they are.
    OctavePoint(const DualCall& call, std::size_t i, std::size_t dimensions, double frequency)
        : count(dimensions) {
        for (std::size_t k = 0; k < count; ++k) {
            const Dual in = call.in(k, i);
            x[k] = k < 3 ? Dual(frequency * in.value, frequency * in.slope) : in;
        }
    }

    Point<most> values() const {
        Point<most> result{};
        for (std::size_t k = 0; k < count; ++k) result[k] = x[k].value;
        return result;
    }

    /// The longer of the two moves of the point across the footprint.
    double step(const DualCall& call, std::size_t i) const {
        double u = 0.0, v = 0.0;
        for (std::size_t k = 0; k < count; ++k) {
            const double along_u = call.along_u(x[k], i), along_v = call.along_v(x[k], i);
            u += along_u * along_u;
            v += along_v * along_v;
        }
        return std::max(std::sqrt(u), std::sqrt(v));
    }

    /// The slope of a number from its derivatives by the coordinates.
    template <class Gradient>
    Vec3d slope(const Gradient& gradient) const {
        Vec3d sum(0.0);
        for (std::size_t k = 0; k < count; ++k) sum = sum + gradient[k] * x[k].slope;
        return sum;
    }
};

/// The share of an octave that a footprint of so many cells shows: all up to 2^-1.7 cells, none
/// from 2^-1.3 on.
double octave_share(double step) {
    return step > 0.0 ? visible_share(-1.0 - binary_log(step), 0) : 1.0;
}

/// Calls add(point, seed, weight) for the octaves that point i shows, weights times `amplitude` and
/// the share that shows; `fineness` is the number of cells to a unit.
template <class Add>
void for_visible(const OctaveLadder& ladder, double amplitude, double fineness,
                 std::size_t dimensions, const DualCall& call, std::size_t i, Add&& add) {
    double frequency = 1.0, weight = amplitude;
    for (std::uint32_t k = 0; k < std::uint32_t(ladder.octaves); ++k) {
        const OctavePoint p(call, i, dimensions, frequency);
        const double share = octave_share(fineness * p.step(call, i));
        if (share > 0.0) add(p, ladder.seed + k, weight * share);
        frequency *= ladder.lacunarity;
        weight *= ladder.gain;
    }
}

template <class Real>
Dual sum_at(const SimplexOctaves& work, double amplitude, const DualCall& call, std::size_t i) {
    const SimplexNoise& noise = work.noise;
    const double fineness = noise.signal == SimplexSignal::wave ? std::max(noise.waves, 1.0) : 1.0;
    Dual total;
    for_visible(work.octaves, amplitude, fineness, noise.dimensions, call, i,
                [&](const OctavePoint& p, std::uint32_t seed, double weight) {
                    const auto n = sample_simplex<Real>(noise, seed, p.values());
                    total.value = total.value + weight * n.value;
                    total.slope = total.slope + weight * p.slope(n.gradient);
                });
    return total;
}

template <class Real>
std::array<Dual, 3> field_at(const CurlOctaves& work, double amplitude, const DualCall& call,
                             std::size_t i) {
    std::array<Dual, 3> total;
    for_visible(work.octaves, amplitude, 1.0, 3, call, i,
                [&](const OctavePoint& p, std::uint32_t seed, double weight) {
                    const Point<3> at{p.x[0].value, p.x[1].value, p.x[2].value};
                    const FieldVector<double> field = sample_curl<Real>(seed, at, work.time);
                    for (std::size_t a = 0; a < 3; ++a) {
                        total[a].value = total[a].value + weight * field.value[a];
                        total[a].slope = total[a].slope + weight * p.slope(field.slope[a]);
                    }
                });
    return total;
}

}  // namespace

DualFunction dual_function(const SimplexOctaves& work, const DualSettings& settings) {
    const auto sum = settings.float32 ? sum_at<float> : sum_at<double>;
    return for_each_point(
        [work, sum, amplitude = work.noise.amplitude()](const DualCall& call, std::size_t i) {
            return sum(work, amplitude, call, i);
        });
}

DualFunction dual_function(const CurlOctaves& work, const DualSettings& settings) {
    const auto field = settings.float32 ? field_at<float> : field_at<double>;
    const double amplitude = simplex_curl_amplitude(work.time ? 4 : 3);
    return [work, field, amplitude](const DualCall& call) {
        for (std::size_t i = 0; i < call.count(); ++i) {
            const std::array<Dual, 3> vector = field(work, amplitude, call, i);
            for (std::size_t a = 0; a < 3; ++a) call.outputs[a]->set(i, vector[a]);
        }
    };
}

}  // namespace burl
