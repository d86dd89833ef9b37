#include "procedural/color/srgb.h"

#include <algorithm>

// This file is compiled once per instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/color/srgb.cpp"
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

Vec3d linear_light(const Rgb8& color) {
    return {srgb_decode(color.r / 255.0), srgb_decode(color.g / 255.0),
            srgb_decode(color.b / 255.0)};
}

double srgb_encode(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

template <class Code>
SrgbEncoder<Code>::SrgbEncoder() : thresholds_(max_code + 1), first_code_(bucket_count) {
    for (std::uint32_t c = 0; c < max_code; ++c) thresholds_[c] = srgb_decode((c + 0.5) / max_code);
    thresholds_[max_code] = std::numeric_limits<double>::infinity();
    // `bucket` never decreases, so a threshold in an earlier bucket is below every value in this
    // one.
    std::uint32_t code = 0;
    for (std::uint32_t b = 0; b < bucket_count; ++b) {
        while (code < max_code && bucket(thresholds_[code]) < b) ++code;
        first_code_[b] = Code(code);
    }
}

template class SrgbEncoder<std::uint8_t>;
template class SrgbEncoder<std::uint16_t>;

SrgbStreamEncoder::SrgbStreamEncoder() {
    static_assert(sizeof(Bucket) == 2 * sizeof(double));
    const SrgbEncoder<std::uint8_t> encode;
    // Buckets are found by a float's square root, which may be off by one at their ends: therefore
    // the first code of a bucket is that of a point a little below it.
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
