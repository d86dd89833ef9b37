#include "procedural/numbers/simd_level.h"

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/numbers/simd_level.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/numbers/vector_types-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

std::size_t SimdLanes() {
    return hn::MaxLanes(Floats());
}

const char* SimdLevel() {
    return hwy::TargetName(HWY_TARGET);
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(SimdLanes);
HWY_EXPORT(SimdLevel);

std::size_t simd_lanes() {
    return HWY_DYNAMIC_DISPATCH(SimdLanes)();
}

std::string simd_level() {
    return HWY_DYNAMIC_DISPATCH(SimdLevel)();
}

}  // namespace burl
#endif
