#include "app/image/hdr_read.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "app/base/file_bytes.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

constexpr std::uint64_t most_hdr_pixels = 1u << 27, most_hdr_bytes = 1ull << 31;

using Rgbe = std::array<std::uint8_t, 4>;

/// Reads bytes one after another. Throws Error(invalid_file) beyond the last.
class HdrBytes {
  public:
    HdrBytes(std::span<const std::uint8_t> bytes, const std::string& path)
        : rest_(bytes), path_(path) {}

    std::uint8_t next() { return take(1)[0]; }
    std::span<const std::uint8_t> take(std::size_t count) {
        if (count > rest_.size()) throw wrong("the file ends too early (truncated)");
        const auto taken = rest_.first(count);
        rest_ = rest_.subspan(count);
        return taken;
    }
    /// The bytes before the next line end, of a line of at most 4096.
    std::string_view line() {
        const auto part = rest_.first(std::min<std::size_t>(rest_.size(), 4097));
        const auto end = std::ranges::find(part, std::uint8_t('\n'));
        if (end == part.end()) throw wrong("it has no header of a Radiance picture");
        const auto length = std::size_t(end - part.begin());
        const auto* text = reinterpret_cast<const char*>(part.data());
        rest_ = rest_.subspan(length + 1);
        return {text, length};
    }
    /// Whether the next bytes begin a row of `width` that is compressed by component.
    bool at_packed_row(std::size_t width) const {
        return width >= 8 && width < 32768 && rest_.size() >= 4 && rest_[0] == 2 && rest_[1] == 2 &&
               rest_[2] == width >> 8 && rest_[3] == (width & 255);
    }
    std::size_t left() const { return rest_.size(); }
    Error wrong(const std::string& what) const { return invalid_file(path_, 0, what); }

  private:
    std::span<const std::uint8_t> rest_;
    const std::string& path_;
};

struct HdrHeader {
    std::size_t width = 0, height = 0;
    double exposure = 1.0;
};

double exposure_of(const HdrBytes& bytes, std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    double value = 0.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc() || !(value > 0.0) || !std::isfinite(value))
        throw bytes.wrong("its EXPOSURE is no positive number");
    return value;
}

/// Reads "-Y HEIGHT +X WIDTH".
void read_size(const HdrBytes& bytes, std::string_view text, HdrHeader& header) {
    const auto number = [&](std::string_view before, std::size_t& value) {
        if (!text.starts_with(before))
            throw Error(ExitCode::unsupported,
                        bytes
                            .wrong("its rows do not run from the top left (-Y N +X M); convert "
                                   "it")
                            .what());
        text.remove_prefix(before.size());
        const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
        if (read.ec != std::errc() || value == 0) throw bytes.wrong("its size is no size");
        text.remove_prefix(std::size_t(read.ptr - text.data()));
    };
    number("-Y ", header.height);
    number(" +X ", header.width);
    if (header.width > most_hdr_pixels || header.height > most_hdr_pixels ||
        header.width * header.height > most_hdr_pixels)
        throw bytes.wrong("it claims more than 2^27 pixels");
}

HdrHeader read_header(HdrBytes& bytes) {
    HdrHeader header;
    if (!bytes.line().starts_with("#?"))
        throw bytes.wrong("it has no header of a Radiance picture");
    for (std::string_view line = bytes.line(); !line.empty(); line = bytes.line()) {
        if (line.starts_with("FORMAT=") && !line.starts_with("FORMAT=32-bit_rle_rgbe"))
            throw Error(ExitCode::unsupported,
                        bytes.wrong("its colours are not RGBE; convert it").what());
        if (line.starts_with("EXPOSURE=")) header.exposure *= exposure_of(bytes, line.substr(9));
    }
    read_size(bytes, bytes.line(), header);
    return header;
}

/// Reads a row whose components are compressed one after another.
void read_packed_row(HdrBytes& bytes, std::vector<Rgbe>& row) {
    bytes.take(4);
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t x = 0; x < row.size();) {
            const std::size_t code = bytes.next();
            const bool run = code > 128;
            const std::size_t count = run ? code - 128 : code;
            if (count == 0 || count > row.size() - x) throw bytes.wrong("a row is too long");
            const auto values = bytes.take(run ? 1 : count);
            for (std::size_t i = 0; i < count; ++i) row[x++][c] = values[run ? 0 : i];
        }
}

/// Reads a row of pixels, of which those of 1, 1, 1 repeat the one before.
void read_plain_row(HdrBytes& bytes, std::vector<Rgbe>& row) {
    int shift = 0;
    for (std::size_t x = 0; x < row.size();) {
        Rgbe pixel;
        std::ranges::copy(bytes.take(4), pixel.begin());
        if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
            row[x++] = pixel, shift = 0;
            continue;
        }
        const std::size_t count = std::size_t(pixel[3]) << shift;
        if (x == 0 || shift > 16 || count > row.size() - x) throw bytes.wrong("a row is too long");
        std::fill_n(row.begin() + std::ptrdiff_t(x), count, row[x - 1]);
        x += count, shift += 8;
    }
}

RgbF light_of(const Rgbe& pixel, double scale) {
    if (pixel[3] == 0) return {};
    const double unit = std::ldexp(scale, int(pixel[3]) - 136);
    return {float(unit * pixel[0]), float(unit * pixel[1]), float(unit * pixel[2])};
}

}  // namespace

Image<RgbF> read_hdr(const std::string& path) {
    const std::vector<std::uint8_t> content = read_regular_file(path, most_hdr_bytes);
    HdrBytes bytes(content, path);
    const HdrHeader header = read_header(bytes);
    if (bytes.left() < 4 * header.height) throw bytes.wrong("the file ends too early (truncated)");
    auto image = Image<RgbF>::unset(header.width, header.height);
    std::vector<Rgbe> row(header.width);
    for (std::size_t y = 0; y < header.height; ++y) {
        if (bytes.at_packed_row(header.width))
            read_packed_row(bytes, row);
        else
            read_plain_row(bytes, row);
        std::ranges::transform(row, image.row(y).begin(), [&](const Rgbe& pixel) {
            return light_of(pixel, 1.0 / header.exposure);
        });
    }
    return image;
}

}  // namespace burl
