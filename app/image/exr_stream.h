#pragma once
// Files that OpenEXR writes through an AtomicFile.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <span>
#include <string>

#include <ImfIO.h>

#include "app/base/atomic_file.h"
#include "atlas/base/error.h"

namespace burl {

/// The side of tiles in pixels.
inline constexpr std::size_t exr_tile_side = 64;
/// The number of rows that are converted and written at a time: a multiple of ZIP's 16, so that
/// threads share them.
inline constexpr std::size_t exr_rows_at_once = 256;

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

    /// Rethrows the exception that a write has thrown, if any, and throws std::bad_alloc where rows
    /// are missing; to be called after the last write.
    void check() const {
        if (failure_) std::rethrow_exception(failure_);
        if (lacks_rows_) throw std::bad_alloc();
    }

  private:
    void write_some(std::span<const std::uint8_t> bytes) {
        const std::size_t old = std::min<std::uint64_t>(bytes.size(), end_ - position_);
        // The offset table at the end: rows that zlib had no memory for are at 0, without an error.
        lacks_rows_ |= old == sizeof(std::uint64_t) &&
                       std::ranges::count(bytes.first(old), std::uint8_t(0)) == std::ptrdiff_t(old);
        if (old > 0) file_.overwrite(position_, bytes.first(old));
        if (old < bytes.size()) file_.write(bytes.subspan(old));
        position_ += bytes.size();
        end_ = std::max(end_, position_);
    }

    AtomicFile& file_;
    std::uint64_t position_ = 0, end_ = 0;  // position_ <= end_
    bool lacks_rows_ = false;
    std::exception_ptr failure_;
};

/// The file that encode(stream) writes. Throws Error: io, or runtime where OpenEXR cannot encode
/// `what` ("OpenEXR image", say) of `width` x `height` pixels.
template <class Encode>
AtomicFile write_exr_stream(const std::string& path, const char* what, std::size_t width,
                            std::size_t height, const Encode& encode) {
    AtomicFile file(path);
    ExrFileStream stream(file);
    try {
        encode(stream);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;  // of the rows' maker, which is not an encoder's failure
    } catch (const std::exception& e) {
        stream.check();
        throw Error(ExitCode::runtime, fmt::format("the {} of {} x {} could not be encoded: {}",
                                                   what, width, height, e.what()));
    }
    stream.check();
    return file;
}

}  // namespace burl
