#pragma once
// OpenEXR writes into memory through this, so that one piece of code (AtomicFile) meets the disk.
#include <cstdint>
#include <cstring>
#include <vector>

#include <ImfIO.h>

namespace burl {

/// Appends to the bytes, which must outlive it.
class ExrStream : public Imf::OStream {
  public:
    explicit ExrStream(std::vector<std::uint8_t>& bytes) : Imf::OStream("image"), bytes_(bytes) {}

    void write(const char data[], int count) override {
        const std::size_t end = position_ + std::size_t(count);
        if (end > bytes_.size()) bytes_.resize(end);
        std::memcpy(bytes_.data() + position_, data, std::size_t(count));
        position_ = end;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

  private:
    std::vector<std::uint8_t>& bytes_;
    std::size_t position_ = 0;
};

}  // namespace burl
