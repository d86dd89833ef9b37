#include "procedural/kernels/share_kernels.h"

#include <algorithm>
#include <type_traits>

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/kernels/share_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/kernels/noise_gradient-inl.h"
#include "procedural/numbers/set_bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// Numbers, for the texels from j on, that are not 0 where a texel does not lie, after `doublings`,
/// in the cell of the texel before it.
HWY_ATTR HWY_INLINE Bit Differing(const LatticeStream& stream, int doublings, std::size_t j) {
    const Bits d;
    const auto difference = [&](const std::uint32_t* numbers) HWY_ATTR {
        return hn::Xor(hn::LoadU(d, numbers + j), hn::LoadU(d, numbers + j - 1));
    };
    const auto& c = stream.cells;
    const Bit cells = hn::Or(hn::Or(difference(c[0]), difference(c[1])), difference(c[2]));
    if (doublings == 0) return cells;
    const auto& p = stream.places;
    const Bit places = hn::Or(hn::Or(difference(p[0]), difference(p[1])), difference(p[2]));
    return hn::Or(cells, hn::ShiftRightSame(places, 32 - doublings));
}

/// run[j] = the number of borders at texels 1..j, where a texel does not lie in the cell of the
/// texel before; positions[i] = the first texel of run i. Returns the number of runs. (Runs of
/// garbage beyond `count` are never read.)
HWY_ATTR std::size_t FindBorders(const LatticeStream& stream, int doublings, std::size_t count,
                                 std::uint32_t* positions, std::uint32_t* run) {
    const Bits d;
    positions[0] = run[0] = 0;
    std::size_t borders = 1;
    for (std::size_t j = 1; j < count; j += hn::Lanes(d)) {
        const auto border = hn::Ne(Differing(stream, doublings, j), hn::Zero(d));
        CountUpTo(MaskBytes(border), std::uint32_t(borders - 1), run + j);
        borders += SetPositions(border, std::uint32_t(j), positions + borders);
    }
    while (borders > 1 && positions[borders - 1] >= count) --borders;
    return borders;
}

HWY_ATTR void FindRuns(const LatticeStream& stream, int doublings, std::size_t count,
                       CellRuns& runs) {
    HWY_ALIGN std::uint32_t positions[batch_capacity + 2 * batch_padding];
    runs.count = FindBorders(stream, doublings, count, positions, runs.run);
    for (std::size_t i = 0; i < runs.count; ++i)
        for (int axis = 0; axis < 3; ++axis) {
            runs.first.cells[axis][i] = stream.cells[axis][positions[i]];
            runs.first.places[axis][i] = stream.places[axis][positions[i]];
        }
    // The elements that kernels read beyond the end belong to the last run.
    std::fill_n(runs.run + count, hn::Lanes(Bits()), std::uint32_t(runs.count - 1));
}

/// The numbers that the texels of a run share: for value noise the PlaneValues of both planes, for
/// Perlin's noise the corners' hashes.
struct SharedCorners {
    alignas(64) std::uint32_t bits[8][batch_capacity + 2 * batch_padding];
};

template <class Corner>
HWY_ATTR void ShareCorners(const StreamOctave& octave, const CellRuns& runs,
                           SharedCorners& shared) {
    const Bits d;
    const Bit seed = hn::Set(d, octave.seed * LatticeHash::prime_seed);
    for (std::size_t i = 0; i < runs.count; i += hn::Lanes(d)) {
        const auto cell = [&](int axis)
                              HWY_ATTR { return CellsOf(runs.first, axis, i, octave.doublings); };
        Bit h = CellHash(seed, cell(0), cell(1), cell(2));
        for (std::size_t k = 0; k < 8; k += 4, h = NextPlane(h)) {
            const PlaneHashes plane(h);
            const auto store = [&](Bit a, Bit b, Bit e, Bit f) HWY_ATTR {
                hn::Store(a, d, shared.bits[k] + i);
                hn::Store(b, d, shared.bits[k + 1] + i);
                hn::Store(e, d, shared.bits[k + 2] + i);
                hn::Store(f, d, shared.bits[k + 3] + i);
            };
            if constexpr (std::is_same_v<Corner, ValueCorner>) {
                const PlaneValues values = ValuesOf(plane);
                store(hn::BitCast(d, values.one), hn::BitCast(d, values.x),
                      hn::BitCast(d, values.y), hn::BitCast(d, values.xy));
            } else {
                store(plane.a, plane.b, plane.e, plane.f);
            }
        }
    }
}

/// The two planes of corners of a vector of texels; `take(k)` gives element k of their
/// SharedCorners.
template <class Corner, class Take>
HWY_ATTR HWY_INLINE auto PlanesTaken(const Take& take) {
    if constexpr (std::is_same_v<Corner, ValueCorner>) {
        const auto plane = [&](std::size_t k) HWY_ATTR {
            const Floats d;
            return PlaneValues(hn::BitCast(d, take(k)), hn::BitCast(d, take(k + 1)),
                               hn::BitCast(d, take(k + 2)), hn::BitCast(d, take(k + 3)));
        };
        return Planes<PlaneValues>{plane(0), plane(4)};
    } else {
        const auto plane = [&](std::size_t k) HWY_ATTR {
            return PlaneHashes(take(k), take(k + 1), take(k + 2), take(k + 3));
        };
        return Planes<PlaneHashes>{plane(0), plane(4)};
    }
}

/// Whether runs are so long that testing a vector of texels for being of one run, which saves the
/// look-ups, pays: where most vectors are not, the test costs more than it gains, because its
/// branch cannot be predicted.
constexpr bool few_borders(const CellRuns& runs, std::size_t count, std::size_t lanes) {
    return 4 * runs.count * lanes < count;
}

/// Calls add(j, places, take) for every vector of texels.
template <class FadeFunction, bool ask, class Add>
HWY_ATTR HWY_INLINE void ForEachVector(const StreamOctave& octave, const LatticeStream& stream,
                                       const CellRuns& runs, const SharedCorners& shared,
                                       std::size_t count, const Add& add) {
    const Bits bits;
    const std::size_t lanes = hn::Lanes(bits);
    for (std::size_t j = 0; j < count; j += lanes) {
        const StreamPlaces<FadeFunction> at(stream, j, octave.doublings);
        const std::uint32_t run = runs.run[j];
        if (ask && run == runs.run[j + lanes - 1]) {
            add(j, at, [&](std::size_t k) HWY_ATTR { return hn::Set(bits, shared.bits[k][run]); });
        } else {
            const auto which =
                hn::IndicesFromVec(bits, hn::Sub(hn::Load(bits, runs.run + j), hn::Set(bits, run)));
            add(j, at, [&](std::size_t k) HWY_ATTR {
                return hn::TableLookupLanes(hn::LoadU(bits, shared.bits[k] + run), which);
            });
        }
    }
}

template <class Corner, class FadeFunction, class Add>
HWY_ATTR void AddShared(const StreamOctave& octave, const LatticeStream& stream,
                        const CellRuns& runs, std::size_t count, const Add& add) {
    SharedCorners shared;
    ShareCorners<Corner>(octave, runs, shared);
    if (few_borders(runs, count, hn::Lanes(Floats())))
        ForEachVector<FadeFunction, true>(octave, stream, runs, shared, count, add);
    else
        ForEachVector<FadeFunction, false>(octave, stream, runs, shared, count, add);
}

template <class Corner, class FadeFunction>
HWY_ATTR void AddOctaveShared(const StreamOctave& octave, const LatticeStream& stream,
                              const CellRuns* runs, std::size_t count, float* sums, GradientSums*) {
    const Float weight = hn::Set(Floats(), octave.weight);
    AddShared<Corner, FadeFunction>(octave, stream, *runs, count,
                                    [&](std::size_t j, const auto& at, const auto& take) HWY_ATTR {
                                        const auto planes = PlanesTaken<Corner>(take);
                                        AddScaled(weight, NoiseOf(at, planes.low, planes.high),
                                                  sums + j);
                                    });
}

template <class Corner, class FadeFunction>
HWY_ATTR void AddOctaveAndGradientShared(const StreamOctave& octave, const LatticeStream& stream,
                                         const CellRuns* runs, std::size_t count, float* sums,
                                         GradientSums* gradients) {
    AddShared<Corner, FadeFunction>(octave, stream, *runs, count,
                                    [&](std::size_t j, const auto& at, const auto& take) HWY_ATTR {
                                        const auto planes = PlanesTaken<Corner>(take);
                                        AddGradient(octave, GradientOf(at, planes.low, planes.high),
                                                    j, sums, *gradients);
                                    });
}

HWY_ATTR OctaveKernel SharingKernel(NoiseKind kind, Fade fade, bool gradients) {
    return with_noise(kind, fade, [&]<class Corner, class FadeFunction>() -> OctaveKernel {
        return gradients ? AddOctaveAndGradientShared<Corner, FadeFunction>
                         : AddOctaveShared<Corner, FadeFunction>;
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(FindRuns);
HWY_EXPORT(SharingKernel);

void find_runs(const LatticeStream& stream, int doublings, std::size_t count, CellRuns& runs) {
    HWY_DYNAMIC_DISPATCH(FindRuns)(stream, doublings, count, runs);
}

OctaveKernel sharing_kernel(NoiseKind kind, Fade fade, bool gradients) {
    return HWY_DYNAMIC_DISPATCH(SharingKernel)(kind, fade, gradients);
}

}  // namespace burl
#endif
