// Names of the vectors that kernels work on, and what makes integers and ramps of them: the same
// for every kernel. Included once per instruction set (hence the toggled guard), after
// hwy/foreach_target.h.
#if defined(BURL_VECTOR_TYPES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BURL_VECTOR_TYPES_INL_H
#undef BURL_VECTOR_TYPES_INL_H
#else
#define BURL_VECTOR_TYPES_INL_H
#endif

#include <cstdint>
#include <iterator>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Doubles = hn::ScalableTag<double>;
using Ints = hn::RebindToSigned<Floats>;
using Bits = hn::RebindToUnsigned<Floats>;
using HalfFloats = hn::Rebind<float, Doubles>;  // as many floats as there are doubles in a vector
using HalfInts = hn::Rebind<std::int32_t, Doubles>;
using HalfBits = hn::Rebind<std::uint32_t, Doubles>;
using Double = hn::Vec<Doubles>;
using Float = hn::Vec<Floats>;
using Bit = hn::Vec<Bits>;

/// Adding this to |y| < 2^51 rounds y to an integer, whose low 32 bits are the sum's low bits.
constexpr double round_magic = 0x1.8p52;

/// 0, 1, 2 ... from memory: Iota builds them lane by lane, 10 ns a call on AVX2.
HWY_ATTR HWY_INLINE hn::Vec<Doubles> LaneNumbers() {
    HWY_ALIGN static constexpr double numbers[] = {0, 1, 2, 3, 4, 5, 6, 7};
    static_assert(std::size(numbers) >= HWY_MAX_BYTES / sizeof(double));
    return hn::Load(Doubles(), numbers);
}

/// Whether a lane's number is below `count`.
HWY_ATTR HWY_INLINE hn::Mask<Floats> FirstLanes(std::size_t count) {
    HWY_ALIGN static constexpr float numbers[] = {0, 1, 2,  3,  4,  5,  6,  7,
                                                  8, 9, 10, 11, 12, 13, 14, 15};
    static_assert(std::size(numbers) >= HWY_MAX_BYTES / sizeof(float));
    return hn::Lt(hn::Load(Floats(), numbers), hn::Set(Floats(), float(count)));
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#endif
