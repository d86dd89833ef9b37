#pragma once
// Output streams of OpenEXR into memory or into an AtomicFile.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <span>
#include <vector>

#include <ImfIO.h>

#include "app/base/atomic_file.h"

namespace burl {

/// A stream into a vector of bytes, which must outlive it.
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

/// A stream into the file, which must outlive it. OpenEXR seeks back to fill in its offset table,
/// which goes through AtomicFile::overwrite. An exception of the file is kept, since OpenEXR may
/// swallow it.
class ExrFileStream : public Imf::OStream {
  public:
    explicit ExrFileStream(AtomicFile& file) : Imf::OStream("image"), file_(file) {}

    void write(const char data[], int count) override {
        const std::span bytes(reinterpret_cast<const std::uint8_t*>(data), std::size_t(count));
        try {
            write_some(bytes);
        } catch (...) {
            failure_ = std::current_exception();
            throw;
        }
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    /// Rethrows the exception that a write has thrown, if any; to be called after the last write.
    void check() const {
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    void write_some(std::span<const std::uint8_t> bytes) {
        const std::size_t old = std::min<std::uint64_t>(bytes.size(), end_ - position_);
        if (old > 0) file_.overwrite(position_, bytes.first(old));
        if (old < bytes.size()) file_.write(bytes.subspan(old));
        position_ += bytes.size();
        end_ = std::max(end_, position_);
    }

    AtomicFile& file_;
    std::uint64_t position_ = 0, end_ = 0;  // position_ <= end_
    std::exception_ptr failure_;
};

}  // namespace burl
