#include "procedural/noise/simplex_signal.h"

namespace burl {

namespace {

constexpr std::size_t most = most_simplex_dimensions;

template <class Real, std::size_t N>
NoiseSample<double, most> sample_in(const SimplexNoise& noise, std::uint32_t seed,
                                    const Point<most>& p) {
    Point<N> q;
    std::copy_n(p.begin(), N, q.begin());
    const auto n = simplex_signal<Real, N>(noise, seed, q);
    NoiseSample<double, most> result{double(n.value), {}};
    std::copy_n(n.gradient.begin(), N, result.gradient.begin());
    return result;
}

}  // namespace

template <class Real>
NoiseSample<double, most> sample_simplex(const SimplexNoise& noise, std::uint32_t seed,
                                         const Point<most>& p) {
    switch (noise.dimensions) {
        case 2:
            return sample_in<Real, 2>(noise, seed, p);
        case 3:
            return sample_in<Real, 3>(noise, seed, p);
        case 4:
            return sample_in<Real, 4>(noise, seed, p);
        case 5:
            return sample_in<Real, 5>(noise, seed, p);
        case 6:
            return sample_in<Real, 6>(noise, seed, p);
        case 7:
            return sample_in<Real, 7>(noise, seed, p);
        default:
            return sample_in<Real, 8>(noise, seed, p);
    }
}

template NoiseSample<double, most> sample_simplex<float>(const SimplexNoise&, std::uint32_t,
                                                         const Point<most>&);
template NoiseSample<double, most> sample_simplex<double>(const SimplexNoise&, std::uint32_t,
                                                          const Point<most>&);

}  // namespace burl
