#pragma once
// The sRGB transfer function (IEC 61966-2-1) and its fast inverse: colours are given and stored
// sRGB-encoded, mixed and averaged in linear light.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/base/srgb.h"
#include "atlas/base/vec.h"

namespace burl {

/// Linear light of a colour, channels in [0, 1].
Vec3d linear_light(const Rgb8& color);

/// The encoded value of linear light, both in [0, 1].
double srgb_encode(double linear);

/// Rounds linear light to the nearest sRGB code 0..max_code (Code: std::uint8_t or std::uint16_t)
/// without a power: it searches the thresholds between codes, starting from a table indexed by the
/// square root. Values below 0 and NaN give 0, values above 1 give max_code.
template <class Code>
class SrgbEncoder {
  public:
    static constexpr std::uint32_t max_code = std::numeric_limits<Code>::max();

    SrgbEncoder();

    Code operator()(double linear) const {
        if (!(linear > 0.0)) return 0;
        if (linear >= 1.0) return Code(max_code);
        std::uint32_t code = first_code_[bucket(linear)];
        while (linear >= thresholds_[code]) ++code;
        return Code(code);
    }

    /// The least linear light of the next higher code.
    double threshold(Code code) const { return thresholds_[code]; }

  private:
    static constexpr std::uint32_t bucket_count = 2 * (max_code + 1);
    static std::uint32_t bucket(double linear) {
        return std::uint32_t(std::sqrt(linear) * bucket_count);
    }

    std::vector<double> thresholds_;  ///< least linear light of the code after each
    std::vector<Code> first_code_;    ///< the lowest code in every bucket
};

/// The 8-bit codes of SrgbEncoder for streams of values, vectorised as in texel_batch.h.
class SrgbStreamEncoder {
  public:
    SrgbStreamEncoder();

    /// codes[i] = SrgbEncoder<std::uint8_t>()(linear[i]) for every i < count. Reads and writes
    /// whole vectors: both arrays hold batch_padding elements more than `count`; `linear` is
    /// aligned to 64 bytes.
    void operator()(const double* linear, std::size_t count, std::uint8_t* codes) const;

    /// One of bucket_count intervals of [0, 1], of equal length in the square root of linear light,
    /// or the interval of 1 itself: short enough to hold at most one threshold between codes.
    struct Bucket {
        double threshold = 0.0;  ///< least linear light whose code is `code` + 1
        /// The code of the bucket's lower values.
        double code = 0.0;
    };
    static constexpr int bucket_count = 512;
    const std::vector<Bucket>& buckets() const { return buckets_; }

  private:
    std::vector<Bucket> buckets_;
};

}  // namespace burl
