#include "procedural/numbers/simd_target.h"

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/numbers/simd_target.cpp"
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

namespace {

/// Calls visit(target) for every target that is compiled in and supported, the best first.
template <class Visit>
void for_each_target(const Visit& visit) {
    // The better a target, the lower its bit.
    for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1)
        visit(left & -left);
}

void choose(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace

std::vector<std::string> simd_targets() {
    std::vector<std::string> names;
    for_each_target([&](std::int64_t target) { names.emplace_back(hwy::TargetName(target)); });
    return names;
}

void use_simd_target(const std::string& name) {
    for_each_target([&](std::int64_t target) {
        if (hwy::TargetName(target) == name) choose(target);
    });
}

OnlySimdTarget::OnlySimdTarget(const std::string& name) : before_(hwy::SupportedTargets()) {
    use_simd_target(name);
}

OnlySimdTarget::~OnlySimdTarget() {
    choose(before_);
}

}  // namespace burl
#endif
