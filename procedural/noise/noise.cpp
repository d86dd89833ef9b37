#include "procedural/noise/noise.h"

#include "procedural/noise/perlin1985.h"
#include "procedural/noise/perlin_noise.h"
#include "procedural/noise/simplex_noise.h"
#include "procedural/noise/value_noise.h"
#include "procedural/noise/worley_noise.h"

namespace burl {

namespace {

template <std::size_t N>
Period<N> leading(const Period<4>& period) {
    Period<N> result;
    for (std::size_t axis = 0; axis < N; ++axis) result[axis] = period[axis];
    return result;
}

template <template <class, std::size_t> class Sample, class Real, std::size_t N>
Sample<Real, N> interpolated(const NoiseSpec& noise, const Point<N>& p) {
    const Period<N> period = leading<N>(noise.period);
    const std::uint32_t seed = noise.seed;
    if constexpr (has_dimensions(NoiseKind::perlin, N)) {
        if (noise.kind == NoiseKind::perlin)
            return perlin_noise<Sample, Real>(
                p, period, [seed](const auto& index) { return lattice_gradient(index, seed); });
        if (noise.kind == NoiseKind::perlin2002)
            return perlin_noise<Sample, Real>(
                p, period, [seed](const auto& index) { return published_gradient(index, seed); });
    }
    if constexpr (has_dimensions(NoiseKind::perlin1985, N))
        if (noise.kind == NoiseKind::perlin1985)
            return perlin1985_noise<Sample, Real>(p, seed, period);
    if (noise.kind == NoiseKind::value)
        return value_noise<Sample, Real>(p, noise.fade, seed, period);
    return {};
}

}  // namespace

template <class Real, std::size_t N>
NoiseSample<Real, N> sample_noise(const NoiseSpec& noise, const Point<N>& p) {
    if constexpr (N == 3)
        if (noise.time) {
            const auto n = sample_noise<Real, 4>(noise, {p[0], p[1], p[2], *noise.time});
            return {n.value, {n.gradient[0], n.gradient[1], n.gradient[2]}};
        }
    const Period<N> period = leading<N>(noise.period);
    switch (noise.kind) {
        case NoiseKind::simplex:
            if constexpr (has_dimensions(NoiseKind::simplex, N))
                return simplex_noise<Real>(
                    p, noise.seed, N == 3 ? noise.radius2 : SimplexShape<N>::radius2, period);
            return {};
        case NoiseKind::worley:
            return worley_noise<Real>(p, noise.feature, noise.seed, period);
        case NoiseKind::cell:
            return cell_noise<Real>(p, noise.seed, period);
        case NoiseKind::white:
            return white_noise<Real>(p, noise.seed, period);
        default:
            return interpolated<NoiseSample, Real>(noise, p);
    }
}

template <class Real, std::size_t N>
Real noise_value(const NoiseSpec& noise, const Point<N>& p) {
    if constexpr (N == 3)
        if (noise.time) return noise_value<Real, 4>(noise, {p[0], p[1], p[2], *noise.time});
    return is_interpolated(noise.kind) ? interpolated<NoiseValue, Real>(noise, p).value
                                       : sample_noise<Real>(noise, p).value;
}

template NoiseSample<float, 1> sample_noise(const NoiseSpec&, const Point<1>&);
template NoiseSample<float, 2> sample_noise(const NoiseSpec&, const Point<2>&);
template NoiseSample<float, 3> sample_noise(const NoiseSpec&, const Point<3>&);
template NoiseSample<float, 4> sample_noise(const NoiseSpec&, const Point<4>&);
template NoiseSample<double, 1> sample_noise(const NoiseSpec&, const Point<1>&);
template NoiseSample<double, 2> sample_noise(const NoiseSpec&, const Point<2>&);
template NoiseSample<double, 3> sample_noise(const NoiseSpec&, const Point<3>&);
template NoiseSample<double, 4> sample_noise(const NoiseSpec&, const Point<4>&);

template float noise_value(const NoiseSpec&, const Point<3>&);
template double noise_value(const NoiseSpec&, const Point<3>&);

double evaluate_noise(const NoiseSpec& noise, const Vec3d& p) {
    return noise_value<double>(noise, Point<3>{p.x, p.y, p.z});
}

double published_perlin_noise(const Vec3d& p) {
    return perlin_noise<NoiseValue, double>(
               Point<3>{p.x, p.y, p.z}, {},
               [](const auto& index) { return published_gradient(index, 0); })
        .value;
}

}  // namespace burl
