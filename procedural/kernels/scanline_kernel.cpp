#include "procedural/kernels/scanline_kernel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <type_traits>

// Compiled once per instruction set (Highway).
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/kernels/scanline_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/kernels/scan_segments-inl.h"
#include "procedural/kernels/stream_noise-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// The vector 0, 1, 2, ... in float32.
HWY_ATTR HWY_INLINE Float FloatLaneNumbers() {
    HWY_ALIGN static constexpr float numbers[] = {0, 1, 2,  3,  4,  5,  6,  7,
                                                  8, 9, 10, 11, 12, 13, 14, 15};
    static_assert(std::size(numbers) >= HWY_MAX_BYTES / sizeof(float));
    return hn::Load(Floats(), numbers);
}

HWY_ATTR HWY_INLINE void SumAndDifference(Float& low, Float& high) {
    const Float sum = hn::Add(low, high);
    high = hn::Sub(high, low), low = sum;
}

/// Turns the values at a cell's corners (bit a of a corner's index is its side on axis a) into
/// eight times the coefficients of a trilinear polynomial of weights in [-1, 1]: coefficient c
/// belongs to the product of the weights whose bits are set in c.
HWY_ATTR HWY_INLINE void Transform(Float* n) {
    for (std::size_t bit = 1; bit < 8; bit *= 2)
        for (std::size_t c = 0; c < 8; ++c)
            if (!(c & bit)) SumAndDifference(n[c], n[c + bit]);
}

/// The trilinear polynomial with the coefficients n at the weights (x, y, z).
HWY_ATTR HWY_INLINE Float Blend(const Float* n, Float x, Float y, Float z) {
    const auto edge = [&](std::size_t c) HWY_ATTR { return hn::Add(n[c], hn::Mul(x, n[c + 1])); };
    const Float low = hn::Add(edge(0), hn::Mul(y, edge(2)));
    return hn::Add(low, hn::Mul(z, hn::Add(edge(4), hn::Mul(y, edge(6)))));
}

/// h[c] = the mixed hashes of corner c of the cells of a vector of segments, beginning with segment
/// i.
HWY_ATTR HWY_INLINE void CornerHashes(Bit seed, const ScanSegments& segments, std::size_t i,
                                      Bit* h) {
    const auto cell = [&](int axis) HWY_ATTR { return hn::Load(Bits(), segments.cells[axis] + i); };
    const Bit h00 = CellHash(seed, cell(0), cell(1), cell(2));
    for (std::uint32_t c = 0; c < 8; ++c) {
        const std::uint32_t offset = (c & 1 ? LatticeHash::prime_x : 0u) +
                                     (c & 2 ? LatticeHash::prime_y : 0u) +
                                     (c & 4 ? LatticeHash::prime_z : 0u);
        h[c] = Mix(hn::Add(h00, hn::Set(Bits(), offset)));
    }
}

/// n = the coefficients (Transform) of value noise, from the corners' hashes.
HWY_ATTR HWY_INLINE void CornerValues(const Bit* h, Float* n) {
    for (std::size_t c = 0; c < 8; ++c) n[c] = ValueOf(h[c]);
    Transform(n);
}

/// The fade v = 2 w - 1 of t, twice the position in the cell: t (3/2 - t^2 / 2) for SmoothFade.
HWY_ATTR HWY_INLINE Float ScanFade(SmoothFade, Float t) {
    const Floats d;
    const Float square = hn::Mul(t, t);
    return hn::Mul(t, hn::Sub(hn::Set(d, 1.5f), hn::Mul(hn::Set(d, 0.5f), square)));
}
HWY_ATTR HWY_INLINE Float ScanFade(QuinticFade fade, Float t) {
    return fade(t);
}

/// The fade on an axis, t texels after the segment's middle: coefficient k is twice the position of
/// the middle, coefficient k + 3 twice the step.
template <class FadeFunction, class Take>
HWY_ATTR HWY_INLINE Float FadeAlong(const Take& take, std::size_t k, Float t) {
    return ScanFade(FadeFunction(), hn::Add(take(k), hn::Mul(t, take(k + 3))));
}

/// Coefficients of value noise with a fade. Every form (ValueForm, CubicForm, PerlinForm) defines
/// two functions: Fill() computes a segment's coefficients from the corners' hashes, twice the
/// position of the segment's middle and twice the step; Noise() gives eight times the noise t
/// texels after the middle, where take(k) gives coefficient k.
template <class FadeFunction>
struct ValueForm {
    static constexpr std::size_t numbers = 14;
    static HWY_ATTR HWY_INLINE void Fill(const Bit* h, const Float* place, const Float* step,
                                         Float* numbers) {
        CornerValues(h, numbers);
        for (std::size_t axis = 0; axis < 3; ++axis)
            numbers[8 + axis] = place[axis], numbers[11 + axis] = step[axis];
    }
    template <class Take>
    static HWY_ATTR HWY_INLINE Float Noise(const Take& take, Float t) {
        Float n[8];
        for (std::size_t k = 0; k < 8; ++k) n[k] = take(k);
        return Blend(n, FadeAlong<FadeFunction>(take, 8, t), FadeAlong<FadeFunction>(take, 9, t),
                     FadeAlong<FadeFunction>(take, 10, t));
    }
};

/// Coefficients of value noise with the linear fade: a cubic polynomial of t.
struct CubicForm {
    static constexpr std::size_t numbers = 4;
    static HWY_ATTR HWY_INLINE void Fill(const Bit* h, const Float* place, const Float* step,
                                         Float* numbers) {
        Float n[8];
        CornerValues(h, n);
        const auto [x, y, z] = std::array{place[0], place[1], place[2]};
        const auto [u, v, w] = std::array{step[0], step[1], step[2]};
        Float e0[4], e1[4];
        for (std::size_t i = 0; i < 4; ++i) {
            e0[i] = hn::Add(n[2 * i], hn::Mul(n[2 * i + 1], x));
            e1[i] = hn::Mul(n[2 * i + 1], u);
        }
        Float q0[2], q1[2], q2[2];
        for (std::size_t i = 0; i < 2; ++i) {
            const std::size_t a = 2 * i, b = a + 1;
            q0[i] = hn::Add(e0[a], hn::Mul(e0[b], y));
            q1[i] = hn::Add(hn::Add(e1[a], hn::Mul(e1[b], y)), hn::Mul(e0[b], v));
            q2[i] = hn::Mul(e1[b], v);
        }
        numbers[0] = hn::Add(q0[0], hn::Mul(q0[1], z));
        numbers[1] = hn::Add(hn::Add(q1[0], hn::Mul(q1[1], z)), hn::Mul(q0[1], w));
        numbers[2] = hn::Add(hn::Add(q2[0], hn::Mul(q2[1], z)), hn::Mul(q1[1], w));
        numbers[3] = hn::Mul(q2[1], w);
    }
    template <class Take>
    static HWY_ATTR HWY_INLINE Float Noise(const Take& take, Float t) {
        const Float high = hn::Add(take(2), hn::Mul(t, take(3)));
        return hn::Add(take(0), hn::Mul(t, hn::Add(take(1), hn::Mul(t, high))));
    }
};

/// Coefficients of Perlin's noise: eight linear functions of t, then positions and steps of the
/// fades.
struct PerlinForm {
    static constexpr std::size_t numbers = 22;
    static HWY_ATTR HWY_INLINE void Fill(const Bit* h, const Float* place, const Float* step,
                                         Float* numbers) {
        const PerlinCorner corner;
        const Float lower = hn::Set(Floats(), 1.0f), upper = hn::Set(Floats(), -1.0f);
        Float corners[8];  // relative to the cell's centre: integers, whose sums are exact
        for (std::size_t c = 0; c < 8; ++c) {
            corners[c] =
                corner(h[c], c & 1 ? upper : lower, c & 2 ? upper : lower, c & 4 ? upper : lower);
            numbers[c] = corner(h[c], place[0], place[1], place[2]);
            numbers[8 + c] = corner(h[c], step[0], step[1], step[2]);
        }
        for (std::size_t k = 0; k < 8; k += 2) SumAndDifference(corners[k], corners[k + 1]);
        for (std::size_t k = 0; k < 16; k += 2) SumAndDifference(numbers[k], numbers[k + 1]);
        for (std::size_t k = 0; k < 8; ++k) numbers[k] = hn::Add(numbers[k], corners[k]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            numbers[16 + axis] = place[axis], numbers[19 + axis] = step[axis];
    }
    template <class Take>
    static HWY_ATTR HWY_INLINE Float Noise(const Take& take, Float t) {
        const Float x = FadeAlong<QuinticFade>(take, 16, t),
                    y = FadeAlong<QuinticFade>(take, 17, t),
                    z = FadeAlong<QuinticFade>(take, 18, t);
        const auto number = [&](std::size_t k)
                                HWY_ATTR { return hn::Add(take(k), hn::Mul(t, take(8 + k))); };
        const auto edge = [&](std::size_t k)
                              HWY_ATTR { return hn::Add(number(k), hn::Mul(x, number(k + 1))); };
        return TwiceLerp(z, TwiceLerp(y, edge(0), edge(2)), TwiceLerp(y, edge(4), edge(6)));
    }
};

/// Fills the coefficients of all segments for one octave.
template <class Form>
HWY_ATTR void FillNumbers(std::uint32_t seed, ScanSegments& segments) {
    const Floats d;
    const Bit seeds = hn::Set(Bits(), seed * LatticeHash::prime_seed);
    for (std::size_t i = 0; i < segments.count; i += hn::Lanes(d)) {
        Bit h[8];
        CornerHashes(seeds, segments, i, h);
        Float place[3], step[3], numbers[Form::numbers];
        for (int axis = 0; axis < 3; ++axis) {
            const Float u = hn::Load(d, segments.places[axis] + i);
            const Float s = hn::Load(d, segments.steps[axis] + i);
            place[axis] = hn::Add(u, u), step[axis] = hn::Add(s, s);
        }
        Form::Fill(h, place, step, numbers);
        for (std::size_t k = 0; k < Form::numbers; ++k)
            hn::Store(numbers[k], d, segments.numbers[k] + i);
    }
}

/// The number of bits of `bits` that are set up to each lane's bit, inclusive.
template <class D>
HWY_ATTR HWY_INLINE hn::Vec<D> CountBits(D d, std::uint32_t bits) {
#if HWY_TARGET != HWY_SCALAR
    if constexpr (hn::MaxLanes(D()) > 8) {
        const hn::Half<D> half;
        const std::uint32_t lower = bits & 0xff;
        const auto before = hn::Set(half, std::uint32_t(bits_up_to[lower][7]));
        return hn::Combine(d, hn::Add(CountBits(half, bits >> 8), before), CountBits(half, lower));
    } else
#endif
        return hn::PromoteTo(d, hn::LoadU(hn::Rebind<std::uint8_t, D>(), bits_up_to[bits].data()));
}

/// Adds the octave to the sums of `count` texels. With `ask` a vector whose texels lie in one
/// segment broadcasts that segment's coefficients; without it, and for other vectors, every lane
/// looks its segment's coefficients up.
template <class Form, bool ask>
HWY_ATTR void AddTexels(float octave_weight, const ScanSegments& segments, std::size_t count,
                        float* sums) {
    const Floats d;
    const Bits bits;
    const std::size_t lanes = hn::Lanes(d);
    const Float weight = hn::Set(d, octave_weight), stride = hn::Set(d, float(lanes));
    const std::uint64_t every = (std::uint64_t(1) << lanes) - 1;
    Float number = FloatLaneNumbers();
    std::size_t begun = 0;
    for (std::size_t j = 0; j < count; j += lanes) {
        const auto borders = std::uint32_t(segments.borders[j / 64] >> j % 64 & every);
        const std::size_t run = begun - 1 + (borders & 1);
        Float noise;
        if (ask && (borders & ~1u) == 0) {
            const auto all = [&](const float* at) HWY_ATTR { return hn::Set(d, at[run]); };
            noise = Form::Noise([&](std::size_t k) HWY_ATTR { return all(segments.numbers[k]); },
                                hn::Sub(number, all(segments.middle)));
        } else {
            const auto which = hn::IndicesFromVec(bits, CountBits(bits, borders & ~1u));
            const auto each = [&](const float* at) HWY_ATTR {
                return hn::BitCast(
                    d, hn::TableLookupLanes(hn::BitCast(bits, hn::LoadU(d, at + run)), which));
            };
            noise = Form::Noise([&](std::size_t k) HWY_ATTR { return each(segments.numbers[k]); },
                                hn::Sub(number, each(segments.middle)));
        }
        hn::Store(hn::Add(hn::Load(d, sums + j), hn::Mul(weight, noise)), d, sums + j);
        number = hn::Add(number, stride);
        begun += std::size_t(std::popcount(borders));
    }
}

/// Adds an octave; vectors are tested for a single segment only where segments are long on average.
template <class Form>
HWY_ATTR void AddScanOf(const StreamOctave& octave, std::span<const ScanLine> lines,
                        ScanSegments& segments, float* sums) {
    const std::size_t count = FindSegments(lines, octave.doublings, segments);
    FillNumbers<Form>(octave.seed, segments);
    if (2 * segments.count * hn::Lanes(Floats()) < count)
        AddTexels<Form, true>(octave.weight, segments, count, sums);
    else
        AddTexels<Form, false>(octave.weight, segments, count, sums);
}

HWY_ATTR void AddOctaveScanline(NoiseKind kind, Fade fade, const StreamOctave& octave,
                                std::span<const ScanLine> lines, ScanSegments& segments,
                                float* sums) {
    with_noise(kind, fade, [&]<class Corner, class FadeFunction>() HWY_ATTR {
        if constexpr (std::is_same_v<Corner, PerlinCorner>)
            AddScanOf<PerlinForm>(octave, lines, segments, sums);
        else if constexpr (std::is_same_v<FadeFunction, LinearFade>)
            AddScanOf<CubicForm>(octave, lines, segments, sums);
        else
            AddScanOf<ValueForm<FadeFunction>>(octave, lines, segments, sums);
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

void map_scan_lines(const Affine3& lattice_from_solid, int doublings, std::span<const Piece> pieces,
                    std::vector<ScanLine>& lines) {
    const double limit = std::ldexp(lattice_limit, -doublings);
    lines.clear();
    for (const Piece& piece : pieces) {
        const LatticeLine& solid = piece.solid;
        LatticeLine line{lattice_from_solid(solid.start), lattice_from_solid.linear * solid.step,
                         solid.first, solid.count};
        const double length = std::max(piece.length, solid.first + double(solid.count));
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(line.start[axis]) + length * std::abs(line.step[axis]) < limit))
                line.start[axis] = line.step[axis] = 0.0;
        lines.push_back({line, length, 1.0 / glm::abs(line.step)});
    }
}

HWY_EXPORT(AddOctaveScanline);

void add_octave_scanline(NoiseKind kind, Fade fade, const StreamOctave& octave,
                         std::span<const ScanLine> lines, ScanSegments& segments, float* sums) {
    HWY_DYNAMIC_DISPATCH(AddOctaveScanline)(kind, fade, octave, lines, segments, sums);
}

}  // namespace burl
#endif
