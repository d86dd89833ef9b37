#pragma once
// Domain warping: a noise evaluated at a point that other noises have moved (Perlin's "perturbed"
// textures of 1985 applied to the lattice coordinates themselves). The gradient follows by the
// chain rule.
#include "procedural/noise/lattice_site.h"

namespace burl {

/// noise(p + strength * w(p)), where warp(axis, p) gives component `axis` of w and `strength` is in
/// cells. In float32 the warped point errs by `strength` times the warp's error.
template <class Real, std::size_t N, class Warp, class Noise>
NoiseSample<Real, N> domain_warp(const Point<N>& p, double strength, Warp&& warp, Noise&& noise) {
    std::array<NoiseSample<Real, N>, N> moves;
    Point<N> q = p;
    for (std::size_t axis = 0; axis < N; ++axis) {
        moves[axis] = warp(axis, p);
        q[axis] += strength * double(moves[axis].value);
    }
    const NoiseSample<Real, N> inner = noise(q);
    NoiseSample<Real, N> result = inner;
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t axis = 0; axis < N; ++axis)
            result.gradient[axis] += Real(strength) * inner.gradient[i] * moves[i].gradient[axis];
    return result;
}

}  // namespace burl
