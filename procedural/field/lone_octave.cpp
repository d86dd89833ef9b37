#include "procedural/field/lone_octave.h"

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/field/lone_octave.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/kernels/fixed_lines-inl.h"
#include "procedural/kernels/stream_noise-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// What the noise of a batch's texels depends on.
struct LoneStream {
    alignas(64) std::uint32_t hash[batch_capacity + batch_padding];  ///< CellHash
    alignas(64) std::uint32_t places[3][batch_capacity + batch_padding];
};

/// The hash is the sum of the cells' upper halves times primes and of `rest`.
HWY_ATTR HWY_INLINE void FillLoneLine(const FixedLines& lines, std::size_t i,
                                      const LatticeLine& line, Bit rest, std::size_t at,
                                      LoneStream& stream) {
    const Doubles d;
    const Bits bits;
    constexpr std::uint32_t primes[] = {LatticeHash::prime_x, LatticeHash::prime_y,
                                        LatticeHash::prime_z};
    const FixedAxis<true> axes[] = {{lines, i, 0}, {lines, i, 1}, {lines, i, 2}};
    const auto lanes = hn::Set(d, double(hn::Lanes(d))), both = hn::Set(d, double(hn::Lanes(bits)));
    auto x = hn::Add(LaneNumbers(), hn::Set(d, line.first));
    for (std::size_t j = at; j < at + line.count; j += hn::Lanes(bits)) {
        Bit hash = rest;
        for (int axis = 0; axis < 3; ++axis) {
            const Halves place(axes[axis].At(x), axes[axis].At(hn::Add(x, lanes)));
            hash = hn::Add(hash, hn::Mul(place.upper, hn::Set(bits, primes[axis])));
            hn::StoreU(place.lower, bits, stream.places[axis] + j);
        }
        hn::StoreU(hash, bits, stream.hash + j);
        x = hn::Add(x, both);
    }
}

/// Whether all lines are near the lattice's origin.
HWY_ATTR bool FillLoneStream(const LoneOctave& octave, const SpanLines& spans, LoneStream& stream) {
    const LineLimits limits{lattice_limit, 0.0};
    constexpr std::uint32_t zero = std::uint32_t(fixed_zero >> 32);
    const Bit rest = hn::Set(
        Bits(), octave.seed * LatticeHash::prime_seed -
                    zero * (LatticeHash::prime_x + LatticeHash::prime_y + LatticeHash::prime_z));
    FixedLines lines;
    const SpanSource source{spans};
    std::size_t at = 0;
    for (std::size_t begin = 0; begin < source.size(); begin += FixedLines::capacity) {
        const std::size_t count = std::min(FixedLines::capacity, source.size() - begin);
        if (!MapLines<true>(octave.lattice_from_solid, limits, source, begin, count, lines))
            return false;
        for (std::size_t i = 0; i < count; ++i) {
            const LatticeLine line = source.Line(begin + i, at);
            source.Prefetch(begin + i, at);
            FillLoneLine(lines, i, line, rest, at, stream);
            at += line.count;
        }
    }
    return true;
}

template <class Corner, class FadeFunction>
HWY_ATTR void AddLoneNoise(const LoneStream& stream, std::size_t count, double scale,
                           const double* from, double* values) {
    const Floats f;
    const Doubles d;
    const auto scales = hn::Set(d, scale);
    for (std::size_t j = 0; j < count; j += hn::Lanes(f)) {
        const StreamPlaces<FadeFunction> at(stream, j, 0);
        const Float noise = WithPlanesOf<Corner>(hn::Load(Bits(), stream.hash + j),
                                                 [&](const auto& low, const auto& high)
                                                     HWY_ATTR { return NoiseOf(at, low, high); });
        HWY_ALIGN float sums[HWY_MAX_BYTES / sizeof(float)];
        hn::Store(hn::Add(hn::Zero(f), noise), f, sums);  // as sums begin: no -0
        for (std::size_t k = 0; k < hn::Lanes(f); k += hn::Lanes(d)) {
            const auto more = hn::Mul(hn::PromoteTo(d, hn::Load(HalfFloats(), sums + k)), scales);
            hn::StoreU(hn::Add(hn::LoadU(d, from + j + k), more), d, values + j + k);
        }
    }
}

HWY_ATTR bool AddLoneOctave(const LoneOctave& octave, const SpanLines& lines, double* values) {
    LoneStream stream;
    if (!FillLoneStream(octave, lines, stream)) return false;
    with_noise(octave.kind, octave.fade, [&]<class Corner, class FadeFunction>() HWY_ATTR {
        AddLoneNoise<Corner, FadeFunction>(stream, lines.texels, octave.scale, lines.needed,
                                           values);
    });
    return true;
}

HWY_ATTR double Crossings(const Affine3& map, const SpanLines& lines) {
    const Doubles d;
    const auto* counts = reinterpret_cast<const std::int32_t*>(lines.counts);
    auto planes = hn::Zero(d), texels = hn::Zero(d);
    for (std::size_t i = 0; i < lines.spans; i += hn::Lanes(d)) {
        const SpanLanes p(lines, i);
        const auto count = hn::PromoteTo(d, hn::LoadU(HalfInts(), counts + i));
        texels = hn::Add(texels, count);
        for (int axis = 0; axis < 3; ++axis) {
            const auto step =
                Dot(map.linear[0][axis], map.linear[1][axis], map.linear[2][axis], p.u, p.v, p.w);
            planes = hn::Add(planes, hn::Mul(count, hn::Abs(step)));
        }
    }
    return hn::GetLane(hn::SumOfLanes(d, planes)) / hn::GetLane(hn::SumOfLanes(d, texels));
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(AddLoneOctave);
HWY_EXPORT(Crossings);

bool add_lone_octave(const LoneOctave& octave, const SpanLines& lines, double* values) {
    return HWY_DYNAMIC_DISPATCH(AddLoneOctave)(octave, lines, values);
}

double crossings_per_texel(const Affine3& lattice_from_solid, const SpanLines& lines) {
    return HWY_DYNAMIC_DISPATCH(Crossings)(lattice_from_solid, lines);
}

}  // namespace burl
#endif
