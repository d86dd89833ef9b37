#include "procedural/field/kept_sums.h"

// Compiled once per instruction set (Highway).
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/field/kept_sums.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

#include "procedural/numbers/vector_types-inl.h"

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

HWY_ATTR void AddKeptSums(std::span<const KeptSummand> summands, double scale, std::size_t count,
                          double* values) {
    const Doubles d;
    const HalfFloats f;
    const auto scales = hn::Set(d, scale);
    std::size_t j = 0;
    for (; j + hn::Lanes(d) <= count; j += hn::Lanes(d)) {
        auto sum = hn::Zero(f);
        for (const auto& [weight, noise] : summands)
            sum = hn::Add(sum, hn::Mul(hn::Set(f, weight), hn::LoadU(f, noise + j)));
        const auto more = hn::Mul(hn::PromoteTo(d, sum), scales);
        hn::StoreU(hn::Add(hn::LoadU(d, values + j), more), d, values + j);
    }
    for (; j < count; ++j) {
        float sum = 0.0f;
        for (const auto& [weight, noise] : summands) sum += weight * noise[j];
        values[j] += double(sum) * scale;
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(AddKeptSums);

void add_kept_sums(std::span<const KeptSummand> summands, double scale, std::size_t count,
                   double* values) {
    HWY_DYNAMIC_DISPATCH(AddKeptSums)(summands, scale, count, values);
}

}  // namespace burl
#endif
