#include "procedural/noise_kernels.h"

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/noise_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/vector_types-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

HWY_ATTR void FillParabolas(std::span<const ParabolaLine> lines, double* values) {
    const Doubles d;
    const auto lanes = hn::Set(d, double(hn::Lanes(d)));
    for (const ParabolaLine& line : lines) {
        const auto c0 = hn::Set(d, line.c0), c1 = hn::Set(d, line.c1), c2 = hn::Set(d, line.c2);
        auto x = hn::Add(LaneNumbers(), hn::Set(d, line.first));
        for (std::size_t j = 0; j < line.count; j += hn::Lanes(d)) {
            const auto slope = hn::Add(c1, hn::Mul(x, c2));
            hn::StoreU(hn::Add(c0, hn::Mul(x, slope)), d, values + j);
            x = hn::Add(x, lanes);
        }
        values += line.count;
    }
}

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

HWY_EXPORT(FillParabolas);
HWY_EXPORT(SimdLanes);
HWY_EXPORT(SimdLevel);

void fill_parabolas(std::span<const ParabolaLine> lines, double* values) {
    HWY_DYNAMIC_DISPATCH(FillParabolas)(lines, values);
}

std::size_t simd_lanes() {
    return HWY_DYNAMIC_DISPATCH(SimdLanes)();
}

std::string simd_level() {
    return HWY_DYNAMIC_DISPATCH(SimdLevel)();
}

}  // namespace burl
#endif
