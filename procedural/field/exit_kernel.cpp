#include "procedural/field/exit_kernel.h"

#include <limits>

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/field/exit_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/numbers/set_bits-inl.h"
#include "procedural/numbers/vector_types-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

/// f or its fraction, and NaN where that is not worth much.
HWY_ATTR HWY_INLINE Double IndexOf(bool repeats, Double f) {
    const Doubles d;
    if (!repeats) return f;
    const auto near = hn::Lt(hn::Abs(f), hn::Set(d, largest_repeated));
    const auto nan = hn::Set(d, std::numeric_limits<double>::quiet_NaN());
    return hn::IfThenElse(near, hn::Sub(f, hn::Floor(f)), nan);
}

HWY_ATTR std::size_t FindUndecided(bool repeats, std::span<const IndexInterval> intervals,
                                   const double* f, std::size_t count, std::uint32_t* positions) {
    const Floats d;
    const std::size_t lanes = hn::Lanes(d), half = hn::Lanes(Doubles());
    std::size_t found = 0;
    for (std::size_t j = 0; j < count; j += lanes) {
        HWY_ALIGN float parts[batch_padding];
        for (std::size_t k = 0; k < lanes; k += half) {
            const Double index = IndexOf(repeats, hn::LoadU(Doubles(), f + j + k));
            hn::Store(hn::DemoteTo(HalfFloats(), index), HalfFloats(), parts + k);
        }
        const Float index = hn::Load(d, parts);
        auto inside = hn::Lt(index, index);
        for (const IndexInterval& interval : intervals) {
            const auto from = hn::Ge(index, hn::Set(d, float(interval.begin)));
            const auto to = hn::Lt(index, hn::Set(d, float(interval.end)));
            inside = hn::Or(inside, hn::And(from, to));
        }
        found += SetPositions(hn::RebindMask(Bits(), hn::Not(inside)), std::uint32_t(j),
                              positions + found);
    }
    return found_below(count, positions, found);
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(FindUndecided);

std::size_t find_undecided(bool repeats, std::span<const IndexInterval> intervals, const double* f,
                           std::size_t count, std::uint32_t* positions) {
    return HWY_DYNAMIC_DISPATCH(FindUndecided)(repeats, intervals, f, count, positions);
}

}  // namespace burl
#endif
