#pragma once
// SrgbEncoder's 8-bit codes for streams of values, vectorised as in texel_batch.h.
#include <cstddef>
#include <cstdint>
#include <vector>

namespace burl {

class SrgbStreamEncoder {
  public:
    SrgbStreamEncoder();

    /// codes[i] = SrgbEncoder<std::uint8_t>()(linear[i]), the same for every value. Reads and
    /// writes whole vectors: both arrays hold batch_padding elements more than `count`, aligned
    /// to 64.
    void operator()(const double* linear, std::size_t count, std::uint8_t* codes) const;

    /// Parts of equal length of [0,1] in the square root of linear light, and one for 1 itself:
    /// short enough to hold at most one threshold between codes.
    struct Bucket {
        double threshold = 0.0;  ///< from here on the code is `code` + 1
        double code = 0.0;
    };
    static constexpr int bucket_count = 512;
    const std::vector<Bucket>& buckets() const { return buckets_; }

  private:
    std::vector<Bucket> buckets_;
};

}  // namespace burl
