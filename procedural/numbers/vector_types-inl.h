// Names of the vectors that kernels work on, the constant that rounds doubles to integers, and the
// numbers of lanes. The file is included once per instruction set (hence the toggled guard), after
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
using HalfFloats = hn::Rebind<float, Doubles>;  // half a vector: one float per double
using HalfInts = hn::Rebind<std::int32_t, Doubles>;
using HalfBits = hn::Rebind<std::uint32_t, Doubles>;
using Double = hn::Vec<Doubles>;
using Float = hn::Vec<Floats>;
using Bit = hn::Vec<Bits>;

/// round_magic + y rounds y, |y| < 2^51, to an integer, whose low 32 bits are the sum's low bits.
constexpr double round_magic = 0x1.8p52;

/// The vector 0, 1, 2 ... loaded from memory: Iota builds it lane by lane, 10 ns a call on AVX2.
HWY_ATTR HWY_INLINE hn::Vec<Doubles> LaneNumbers() {
    HWY_ALIGN static constexpr double numbers[] = {0, 1, 2, 3, 4, 5, 6, 7};
    static_assert(std::size(numbers) >= HWY_MAX_BYTES / sizeof(double));
    return hn::Load(Doubles(), numbers);
}

/// The mask of the lanes 0..count - 1.
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
