#pragma once
// The 8-bit codes of SrgbEncoder for streams of values, vectorised as in texel_batch.h.
#include <cstddef>
#include <cstdint>
#include <vector>

namespace burl {

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
