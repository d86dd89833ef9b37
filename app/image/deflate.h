#pragma once
// DEFLATE (RFC 1951) by libdeflate, in pieces that are compressed apart and joined into one stream:
// libdeflate has no sync flush, so the last block's final bit is found and cleared here, and an
// empty stored block ends the piece on a byte.
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

struct libdeflate_compressor;

namespace burl {

/// A compressor of one level, 0 (stored) to 12, for use by one thread at a time.
class Deflater {
  public:
    explicit Deflater(int level);

    /// A whole stream of the bytes. Throws Error(runtime) where libdeflate fails.
    std::vector<std::uint8_t> stream(std::span<const std::uint8_t> bytes) const;

    /// A piece of a stream that goes on: no block is final, and it ends on a byte. Throws
    /// Error(runtime) where libdeflate fails.
    std::vector<std::uint8_t> piece(std::span<const std::uint8_t> bytes) const;

  private:
    struct Free {
        void operator()(libdeflate_compressor* compressor) const;
    };
    std::unique_ptr<libdeflate_compressor, Free> compressor_;
};

/// The place of the last block of a whole stream, in bits from its begin: that of its header, and
/// that after its last code. Throws Error(runtime) for bytes that are no stream.
struct LastBlock {
    std::size_t begin = 0, end = 0;
};
LastBlock last_block(std::span<const std::uint8_t> stream);

}  // namespace burl
