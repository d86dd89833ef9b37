#include "procedural/field/break_kernel.h"

// Compiled once per instruction set (Highway).
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/field/break_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/numbers/set_bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

HWY_ATTR std::size_t FindBent(const float* distances, const std::int32_t* entries,
                              const SlopeBatch& slopes, std::size_t count, std::uint32_t* texels) {
    const Floats d;
    std::size_t found = 0;
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        const Float sum =
            hn::Add(hn::Abs(hn::Load(d, slopes.u + j)), hn::Abs(hn::Load(d, slopes.v + j)));
        const Float half = hn::Mul(sum, hn::Set(d, 0.5f));
        const auto straight =
            hn::Lt(half, hn::GatherIndex(d, distances, hn::Load(Ints(), entries + j)));
        found += SetPositions(hn::RebindMask(Bits(), hn::Not(straight)), std::uint32_t(j),
                              texels + found);
    }
    return found_below(count, texels, found);
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(FindBent);

std::size_t find_bent(const float* distances, const std::int32_t* entries, const SlopeBatch& slopes,
                      std::size_t count, std::uint32_t* texels) {
    return HWY_DYNAMIC_DISPATCH(FindBent)(distances, entries, slopes, count, texels);
}

}  // namespace burl
#endif
