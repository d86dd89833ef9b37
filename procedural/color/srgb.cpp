#include "procedural/color/srgb.h"

namespace burl {

double srgb_decode(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

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

}  // namespace burl
