// Buckets are found by a float's square root, which may be off by one at their ends: therefore the
// first code of a bucket is that of a point a little below it.
#include "procedural/color/srgb_kernels.h"

#include <algorithm>

#include "procedural/color/srgb.h"

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/color/srgb_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace burl {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

HWY_ATTR void EncodeSrgb(const SrgbStreamEncoder::Bucket* buckets, const double* linear,
                         std::size_t count, std::uint8_t* codes) {
    const hn::ScalableTag<double> d;
    const hn::Rebind<float, decltype(d)> floats;
    const hn::Rebind<std::int32_t, decltype(d)> ints;
    const hn::Rebind<std::int64_t, decltype(d)> longs;
    const hn::Rebind<std::uint8_t, decltype(d)> bytes;
    const double* table = &buckets->threshold;
    const auto zero = hn::Zero(d), one = hn::Set(d, 1.0);
    const auto scale = hn::Set(floats, float(SrgbStreamEncoder::bucket_count));
    for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
        const auto v = hn::Load(d, linear + j);
        const auto x = hn::Min(hn::IfThenElseZero(hn::Gt(v, zero), v), one);  // NaN: 0
        const auto root = hn::Sqrt(hn::DemoteTo(floats, x));
        const auto bucket = hn::PromoteTo(longs, hn::ConvertTo(ints, hn::Mul(root, scale)));
        // A bucket is two doubles.
        const auto at = hn::Add(bucket, bucket);
        const auto threshold = hn::GatherIndex(d, table, at);
        const auto first = hn::GatherIndex(d, table + 1, at);
        const auto code = hn::Add(first, hn::IfThenElseZero(hn::Ge(x, threshold), one));
        hn::StoreU(hn::DemoteTo(bytes, hn::DemoteTo(ints, code)), bytes, codes + j);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace burl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burl {

HWY_EXPORT(EncodeSrgb);

SrgbStreamEncoder::SrgbStreamEncoder() {
    static_assert(sizeof(Bucket) == 2 * sizeof(double));
    const SrgbEncoder<std::uint8_t> encode;
    for (int i = 0; i <= bucket_count; ++i) {
        const double root = std::max(i - 0.01, 0.0) / bucket_count;
        const std::uint8_t code = encode(root * root);
        buckets_.push_back({encode.threshold(code), double(code)});
    }
}

void SrgbStreamEncoder::operator()(const double* linear, std::size_t count,
                                   std::uint8_t* codes) const {
    HWY_DYNAMIC_DISPATCH(EncodeSrgb)(buckets_.data(), linear, count, codes);
}

}  // namespace burl
#endif
