#include "app/image/exr_read.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>

#include "app/base/file_bytes.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

constexpr std::int64_t most_exr_pixels = 1 << 27;
constexpr std::uint64_t most_exr_bytes = 1ull << 32;

/// A file's bytes as a stream of OpenEXR.
class ExrBytes : public Imf::IStream {
  public:
    ExrBytes(std::span<const std::uint8_t> bytes, const std::string& path)
        : Imf::IStream(path.c_str()), bytes_(bytes) {}

    bool read(char* to, int count) override {
        if (count < 0 || at_ > bytes_.size() || std::size_t(count) > bytes_.size() - at_)
            throw std::runtime_error("the file ends too early (truncated)");
        std::memcpy(to, bytes_.data() + at_, std::size_t(count));
        at_ += std::size_t(count);
        return at_ < bytes_.size();
    }
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t position) override { at_ = position; }

  private:
    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

/// The channel's name for each component of a colour.
std::array<const char*, 3> light_channels(const Imf::ChannelList& all, const std::string& path) {
    const auto usable = [&](const char* name) {
        const Imf::Channel* channel = all.findChannel(name);
        return channel && channel->xSampling == 1 && channel->ySampling == 1;
    };
    if (usable("R") && usable("G") && usable("B")) return {"R", "G", "B"};
    if (usable("Y") && !all.findChannel("RY")) return {"Y", "Y", "Y"};
    throw Error(ExitCode::unsupported,
                fmt::format("{}: it has no channels R, G and B at full size; convert it", path));
}

/// More pixels than a byte of a file can hold: zlib packs 1032 bytes into one, and the compression
/// by blocks (DWA) 64 pixels before that.
std::int64_t most_pixels_per_byte(Imf::Compression compression) {
    const bool blocks =
        compression == Imf::DWAA_COMPRESSION || compression == Imf::DWAB_COMPRESSION;
    return blocks ? 64 * 1032 : 1032;
}

/// Throws Error(invalid_file) where a file of so many bytes cannot hold so many pixels, for which
/// memory would be filled first.
void check_pixels(const Imf::Header& header, std::int64_t pixels, std::size_t bytes,
                  const std::string& path) {
    if (pixels / most_pixels_per_byte(header.compression()) > std::int64_t(bytes))
        throw invalid_file(
            path, 0,
            fmt::format("it claims {} pixels, but has {} bytes only (truncated)", pixels, bytes));
}

Image<RgbF> read_light(Imf::InputFile& file, std::size_t bytes, const std::string& path) {
    const Imath::Box2i box = file.header().dataWindow();
    const std::int64_t width = std::int64_t{box.max.x} - box.min.x + 1,
                       height = std::int64_t{box.max.y} - box.min.y + 1;
    if (width <= 0 || height <= 0 || width > most_exr_pixels / height)
        throw invalid_file(path, 0, "it claims more than 2^27 pixels, or none");
    check_pixels(file.header(), width * height, bytes, path);
    const auto names = light_channels(file.header().channels(), path);
    Image<RgbF> image{std::size_t(width), std::size_t(height)};
    Imf::FrameBuffer frame;
    auto* const first = reinterpret_cast<char*>(image.row(0).data());
    constexpr std::size_t step = sizeof(RgbF);
    for (std::size_t c = 0; c < 3; ++c)
        if (c == 0 || names[c] != names[0])
            frame.insert(names[c], Imf::Slice::Make(Imf::FLOAT, first + c * sizeof(float), box,
                                                    step, step * std::size_t(width)));
    file.setFrameBuffer(frame);
    file.readPixels(box.min.y, box.max.y);
    if (names[1] != names[0]) return image;
    return converted<RgbF>(image, [](const RgbF& p) { return RgbF{p.r, p.r, p.r}; });
}

}  // namespace

Image<RgbF> read_exr(const std::string& path) {
    const std::vector<std::uint8_t> content = read_regular_file(path, most_exr_bytes);
    ExrBytes stream(content, path);
    try {
        Imf::InputFile file(stream);
        return read_light(file, content.size(), path);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& e) {
        std::string reason = e.what();
        std::ranges::replace(reason, '\n', ' ');
        throw invalid_file(path, 0, fmt::format("it is not read as OpenEXR: {}", reason));
    }
}

}  // namespace burl
