#include "procedural/kernels/simplex_kernel.h"

#include <cmath>

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/kernels/simplex_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/kernels/simplex_corners-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

HWY_ATTR HWY_INLINE SimplexSites SitesAt(const LatticeStream& stream, int doublings,
                                         std::size_t j) {
    Bit cell[3], place[3];
    for (int axis = 0; axis < 3; ++axis) {
        cell[axis] = CellsOf(stream, axis, j, doublings);
        place[axis] = PlaceBitsOf(stream, axis, j, doublings);
    }
    return SitesOf(cell, place);
}

/// The shift of the corners of cubes by a seed, along each axis.
struct SeedShift {
    std::uint32_t along[3];

    explicit SeedShift(std::uint32_t seed)
        : along{LatticeHash::shift(seed, 0), LatticeHash::shift(seed, 1),
                LatticeHash::shift(seed, 2)} {}
};

/// radius^2 less the squared distance, or 0 where that is negative. The squares are summed first,
/// because their sum is small where the kernel is large.
HWY_ATTR HWY_INLINE Float Height(Float radius, const Float* offset) {
    return hn::Max(hn::Sub(radius, Dot(offset, offset)), hn::Zero(Floats()));
}

HWY_ATTR HWY_INLINE void AddScaledTo(float* sum, Float weight, Float term) {
    const Floats d;
    hn::Store(hn::Add(hn::Load(d, sum), hn::Mul(weight, term)), d, sum);
}

HWY_ATTR void AddSimplexOctave(const StreamOctave& octave, const LatticeStream& stream,
                               const CellRuns*, std::size_t count, float* sums, GradientSums*) {
    const Floats d;
    const SeedShift shift(octave.seed);
    const Float radius = hn::Set(d, float(octave.radius2)), weight = hn::Set(d, octave.weight);
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        Float noise = hn::Zero(d);
        ForEachCorner(SitesAt(stream, octave.doublings, j), shift.along,
                      [&](const Float* g, const Float* offset) HWY_ATTR {
                          const Float t = Height(radius, offset), t2 = hn::Mul(t, t);
                          const Float t4 = hn::Mul(t2, t2);
                          noise = hn::Add(noise, hn::Mul(t4, Dot(g, offset)));
                      });
        AddScaledTo(sums + j, weight, noise);
    }
}

HWY_ATTR void AddSimplexOctaveAndGradient(const StreamOctave& octave, const LatticeStream& stream,
                                          const CellRuns*, std::size_t count, float* sums,
                                          GradientSums* gradients) {
    const Floats d;
    const SeedShift shift(octave.seed);
    const Float radius = hn::Set(d, float(octave.radius2)), weight = hn::Set(d, octave.weight);
    const Float steepness = hn::Set(d, std::ldexp(octave.weight, octave.doublings));
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        Float noise = hn::Zero(d), along[3] = {noise, noise, noise};
        ForEachCorner(
            SitesAt(stream, octave.doublings, j), shift.along,
            [&](const Float* g, const Float* offset) HWY_ATTR {
                const Float t = Height(radius, offset), t2 = hn::Mul(t, t);
                const Float t4 = hn::Mul(t2, t2), slope = Dot(g, offset);
                noise = hn::Add(noise, hn::Mul(t4, slope));
                // d(t^4) / d(offset) is -8 t^3 offset.
                const Float fall = hn::Mul(hn::Mul(hn::Set(d, 8.0f), hn::Mul(t2, t)), slope);
                for (int axis = 0; axis < 3; ++axis)
                    along[axis] = hn::Add(
                        along[axis], hn::Sub(hn::Mul(t4, g[axis]), hn::Mul(fall, offset[axis])));
            });
        AddScaledTo(sums + j, weight, noise);
        for (int axis = 0; axis < 3; ++axis)
            AddScaledTo(gradients->along[axis] + j, steepness, along[axis]);
    }
}

HWY_ATTR OctaveKernel SimplexKernel(bool gradients) {
    return gradients ? AddSimplexOctaveAndGradient : AddSimplexOctave;
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(SimplexKernel);

OctaveKernel simplex_kernel(bool gradients) {
    return HWY_DYNAMIC_DISPATCH(SimplexKernel)(gradients);
}

}  // namespace burl
#endif
