#include "procedural/share_kernels.h"

#include <array>
#include <bit>
#include <type_traits>

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/share_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/stream_sites-inl.h"

#ifndef BURL_SHARE_KERNELS_SET_BITS
#define BURL_SHARE_KERNELS_SET_BITS
namespace burl {

/// The numbers of the set bits of a byte, in order.
inline constexpr auto set_bits = [] {
    std::array<std::array<std::uint8_t, 8>, 256> table{};
    for (std::size_t byte = 0; byte < table.size(); ++byte)
        for (std::uint8_t bit = 0, i = 0; bit < 8; ++bit)
            if (byte >> bit & 1) table[byte][i++] = bit;
    return table;
}();

}  // namespace burl
#endif

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

using Longs = hn::RebindToUnsigned<Doubles>;
using Eight = hn::CappedTag<std::uint32_t, 8>;

/// Whether any bit of `bits` differs between a texel and the one before it, for texels j and on.
HWY_ATTR HWY_INLINE hn::Vec<Longs> Differing(const LatticeStream& stream, std::uint64_t bits,
                                             std::size_t j) {
    const Longs d;
    auto differing = hn::Zero(d);
    for (const auto& at : stream.at)
        differing = hn::Or(differing, hn::Xor(hn::LoadU(d, at + j), hn::LoadU(d, at + j - 1)));
    return hn::And(differing, hn::Set(d, bits));
}

/// positions[i] = the texels that do not lie in the cell of the texel before; how many.
HWY_ATTR std::size_t FindBorders(const LatticeStream& stream, int doublings, std::size_t count,
                                 std::uint32_t* positions) {
    const Longs d;
    const Eight eight;
    // Doublings shift a cell's bits into the upper half and beyond: all of them must agree.
    const std::uint64_t cell_bits = ~std::uint64_t(0) << (32 - doublings);
    positions[0] = 0;
    std::size_t borders = 1;
    for (std::size_t j = 1; j < count; j += hn::Lanes(eight)) {
        std::uint8_t mask = 0;
        for (std::size_t k = 0; k < hn::Lanes(eight); k += hn::Lanes(d)) {
            const auto border = hn::Ne(Differing(stream, cell_bits, j + k), hn::Zero(d));
            std::uint8_t bits[8] = {};
            hn::StoreMaskBits(d, border, bits);
            mask = std::uint8_t(mask | bits[0] << k);
        }
        // (Compress copies its table on every call, Highway 1.0.3 with g++ 12.)
        const auto places = hn::PromoteTo(
            eight, hn::LoadU(hn::Rebind<std::uint8_t, Eight>(), set_bits[mask].data()));
        hn::StoreU(hn::Add(places, hn::Set(eight, std::uint32_t(j))), eight, positions + borders);
        borders += std::size_t(std::popcount(mask));
    }
    while (borders > 1 && positions[borders - 1] >= count) --borders;
    return borders;
}

HWY_ATTR void FindRuns(const LatticeStream& stream, int doublings, std::size_t count,
                       CellRuns& runs) {
    const Ints ints;
    const std::size_t lanes = hn::Lanes(ints);
    HWY_ALIGN std::uint32_t positions[batch_capacity + 2 * batch_padding];
    runs.count = FindBorders(stream, doublings, count, positions);
    positions[runs.count] =
        std::uint32_t(count + lanes);  // what is read beyond the end belongs to the last run
    for (std::size_t i = 0; i < runs.count; ++i) {
        const std::size_t begin = positions[i], end = positions[i + 1];
        for (int axis = 0; axis < 3; ++axis) runs.first.at[axis][i] = stream.at[axis][begin];
        const auto number = hn::Set(ints, std::int32_t(i));
        for (std::size_t j = begin; j < end; j += lanes) hn::StoreU(number, ints, runs.run + j);
    }
}

/// What the texels of a run share: for value noise sums and differences of the four pairs of
/// corners along x, which TwiceLerp begins with; for Perlin's the corners' hashes.
struct SharedCorners {
    alignas(64) std::uint32_t bits[8][batch_capacity + 2 * batch_padding];
};

template <class Corner>
HWY_ATTR void ShareCorners(const StreamOctave& octave, const CellRuns& runs,
                           SharedCorners& shared) {
    const Bits bits;
    const Bit seed = hn::Set(bits, octave.seed * LatticeHash::prime_seed);
    const Bit next_x = hn::Set(bits, LatticeHash::prime_x);
    for (std::size_t i = 0; i < runs.count; i += hn::Lanes(bits)) {
        Bit cell[3];
        for (int axis = 0; axis < 3; ++axis)
            cell[axis] = CellsOf(runs.first.at[axis] + i, octave.doublings);
        const Bit h00 = CellHash(seed, cell[0], cell[1], cell[2]);
        for (std::uint32_t pair = 0; pair < 4; ++pair) {
            const std::uint32_t offset =
                (pair & 1 ? LatticeHash::prime_y : 0u) + (pair & 2 ? LatticeHash::prime_z : 0u);
            const Bit h = hn::Add(h00, hn::Set(bits, offset));
            Bit first = Mix(h), second = Mix(hn::Add(h, next_x));
            if constexpr (std::is_same_v<Corner, ValueCorner>) {
                const Float none = hn::Zero(Floats());
                const Float a = Corner()(first, none, none, none);
                const Float b = Corner()(second, none, none, none);
                first = hn::BitCast(bits, hn::Add(a, b));
                second = hn::BitCast(bits, hn::Sub(b, a));
            }
            hn::Store(first, bits, shared.bits[2 * pair] + i);
            hn::Store(second, bits, shared.bits[2 * pair + 1] + i);
        }
    }
}

/// What a vector of texels takes from SharedCorners: `take(k)` gives number k of the eight.
template <class Corner, class FadeFunction, class Take>
HWY_ATTR HWY_INLINE Float SharedNoise(const Float* place, const Take& take) {
    const Floats d;
    const FadeFunction fade;
    const Float x = place[0], y = place[1], z = place[2];
    const Float fx = fade(hn::Add(x, x)), fy = fade(hn::Add(y, y)), fz = fade(hn::Add(z, z));
    Float along_x[4];
    if constexpr (std::is_same_v<Corner, ValueCorner>) {
        for (std::size_t pair = 0; pair < 4; ++pair)
            along_x[pair] = hn::Add(hn::BitCast(d, take(2 * pair)),
                                    hn::Mul(fx, hn::BitCast(d, take(2 * pair + 1))));
    } else {
        const Corner corner;
        const Float half = hn::Set(d, 0.5f);
        const Float x0 = hn::Add(x, half), x1 = hn::Sub(x, half);
        for (std::size_t pair = 0; pair < 4; ++pair) {
            const Float dy = pair & 1 ? hn::Sub(y, half) : hn::Add(y, half);
            const Float dz = pair & 2 ? hn::Sub(z, half) : hn::Add(z, half);
            along_x[pair] = TwiceLerp(fx, corner(take(2 * pair), x0, dy, dz),
                                      corner(take(2 * pair + 1), x1, dy, dz));
        }
    }
    return TwiceLerp(fz, TwiceLerp(fy, along_x[0], along_x[1]),
                     TwiceLerp(fy, along_x[2], along_x[3]));
}

template <class Corner, class FadeFunction>
HWY_ATTR void AddSharedOf(const StreamOctave& octave, const LatticeStream& stream,
                          const CellRuns& runs, std::size_t count, float* sums) {
    const Floats d;
    const Bits bits;
    const std::size_t lanes = hn::Lanes(d);
    SharedCorners shared;
    ShareCorners<Corner>(octave, runs, shared);
    const Float weight = hn::Set(d, octave.weight);
    for (std::size_t j = 0; j < count; j += lanes) {
        Float place[3];
        for (int axis = 0; axis < 3; ++axis)
            place[axis] = PlacesOf(stream.at[axis] + j, octave.doublings);
        const std::int32_t run = runs.run[j];
        Float noise;
        if (run == runs.run[j + lanes - 1]) {
            noise = SharedNoise<Corner, FadeFunction>(
                place, [&](std::size_t k) HWY_ATTR { return hn::Set(bits, shared.bits[k][run]); });
        } else {
            const auto which = hn::IndicesFromVec(
                bits, hn::Sub(hn::Load(Ints(), runs.run + j), hn::Set(Ints(), run)));
            noise = SharedNoise<Corner, FadeFunction>(place, [&](std::size_t k) HWY_ATTR {
                return hn::TableLookupLanes(hn::LoadU(bits, shared.bits[k] + run), which);
            });
        }
        hn::Store(hn::Add(hn::Load(d, sums + j), hn::Mul(weight, noise)), d, sums + j);
    }
}

HWY_ATTR void AddOctaveShared(NoiseKind kind, Fade fade, const StreamOctave& octave,
                              const LatticeStream& stream, const CellRuns& runs, std::size_t count,
                              float* sums) {
    with_noise(kind, fade, [&]<class Corner, class FadeFunction>() HWY_ATTR {
        AddSharedOf<Corner, FadeFunction>(octave, stream, runs, count, sums);
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(FindRuns);
HWY_EXPORT(AddOctaveShared);

void find_runs(const LatticeStream& stream, int doublings, std::size_t count, CellRuns& runs) {
    HWY_DYNAMIC_DISPATCH(FindRuns)(stream, doublings, count, runs);
}

void add_octave_shared(NoiseKind kind, Fade fade, const StreamOctave& octave,
                       const LatticeStream& stream, const CellRuns& runs, std::size_t count,
                       float* sums) {
    HWY_DYNAMIC_DISPATCH(AddOctaveShared)
    (kind, fade, octave, stream, runs, count, sums);
}

}  // namespace burl
#endif
