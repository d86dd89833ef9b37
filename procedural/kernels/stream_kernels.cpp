#include "procedural/kernels/stream_kernels.h"

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/kernels/stream_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/kernels/stream_noise-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

template <class Corner, class FadeFunction>
HWY_ATTR void AddOctave(const StreamOctave& octave, const LatticeStream& stream, const CellRuns*,
                        std::size_t count, float* sums, GradientSums*) {
    const Floats d;
    const Bit seed = hn::Set(Bits(), octave.seed * LatticeHash::prime_seed);
    const Float weight = hn::Set(d, octave.weight);
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        const auto cell = [&](int axis)
                              HWY_ATTR { return CellsOf(stream, axis, j, octave.doublings); };
        const StreamPlaces<FadeFunction> at(stream, j, octave.doublings);
        const auto planes = PlanesOf<Corner>(CellHash(seed, cell(0), cell(1), cell(2)));
        AddScaled(weight, NoiseOf(at, planes.low, planes.high), sums + j);
    }
}

HWY_ATTR OctaveKernel DirectKernel(NoiseKind kind, Fade fade) {
    return with_noise(kind, fade, []<class Corner, class FadeFunction>() -> OctaveKernel {
        return AddOctave<Corner, FadeFunction>;
    });
}

HWY_ATTR void AddScaledNoise(float weight, const float* noise, std::size_t count, float* sums) {
    const Floats d;
    const auto weights = hn::Set(d, weight);
    for (std::size_t j = 0; j < count; j += hn::Lanes(d))
        hn::Store(hn::Add(hn::Load(d, sums + j), hn::Mul(weights, hn::LoadU(d, noise + j))), d,
                  sums + j);
}

HWY_ATTR void AddSumsTo(const double* from, double scale, const float* sums, std::size_t count,
                        double* values) {
    const Doubles d;
    const auto scales = hn::Set(d, scale);
    std::size_t j = 0;
    for (; j + hn::Lanes(d) <= count; j += hn::Lanes(d)) {
        const auto sum = hn::PromoteTo(d, hn::Load(HalfFloats(), sums + j));
        hn::StoreU(hn::Add(hn::LoadU(d, from + j), hn::Mul(sum, scales)), d, values + j);
    }
    for (; j < count; ++j) values[j] = from[j] + double(sums[j]) * scale;
}

HWY_ATTR void AddKeptSums(std::span<const KeptSummand> summands, double scale, std::size_t count,
                          double* values) {
    const Doubles d;
    const HalfFloats f;
    const auto scales = hn::Set(d, scale);
    std::size_t j = 0;
    for (; j + hn::Lanes(d) <= count; j += hn::Lanes(d)) {
        auto sum = hn::Zero(f);
        for (const auto& [weight, noise] : summands)
            sum = hn::Add(sum, hn::Mul(hn::Set(f, weight), hn::LoadU(f, noise + j)));
        const auto more = hn::Mul(hn::PromoteTo(d, sum), scales);
        hn::StoreU(hn::Add(hn::LoadU(d, values + j), more), d, values + j);
    }
    for (; j < count; ++j) {
        float sum = 0.0f;
        for (const auto& [weight, noise] : summands) sum += weight * noise[j];
        values[j] += double(sum) * scale;
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(DirectKernel);
HWY_EXPORT(AddScaledNoise);
HWY_EXPORT(AddSumsTo);
HWY_EXPORT(AddKeptSums);

OctaveKernel direct_kernel(NoiseKind kind, Fade fade) {
    return HWY_DYNAMIC_DISPATCH(DirectKernel)(kind, fade);
}

void add_scaled(float weight, const float* noise, std::size_t count, float* sums) {
    HWY_DYNAMIC_DISPATCH(AddScaledNoise)(weight, noise, count, sums);
}

void add_sums_to(const double* from, double scale, const float* sums, std::size_t count,
                 double* values) {
    HWY_DYNAMIC_DISPATCH(AddSumsTo)(from, scale, sums, count, values);
}

void add_sums(double scale, const float* sums, std::size_t count, double* values) {
    add_sums_to(values, scale, sums, count, values);
}

void add_kept_sums(std::span<const KeptSummand> summands, double scale, std::size_t count,
                   double* values) {
    HWY_DYNAMIC_DISPATCH(AddKeptSums)(summands, scale, count, values);
}

}  // namespace burl
#endif
