// Animated PNG (W3C, "PNG Specification (Third Edition)", 2025, section 11.3.4): every
// frame is encoded as a PNG of its own, whose data become chunks of one file.
#include <span>
#include <string_view>
#include <utility>

#include <zlib.h>

#include "app/base/atomic_file.h"
#include "app/image/frame_writer.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

constexpr int apng_level = 8;  // libdeflate's; these files are sent, not only kept
constexpr std::size_t png_signature_size = 8, chunk_frame = 12;  // length, type and checksum

using Bytes = std::vector<std::uint8_t>;

void append_number(Bytes& bytes, std::uint32_t number, int size) {
    for (int shift = 8 * (size - 1); shift >= 0; shift -= 8)
        bytes.push_back(std::uint8_t(number >> shift));
}

std::uint32_t number_at(std::span<const std::uint8_t> bytes) {
    return std::uint32_t(bytes[0]) << 24 | std::uint32_t(bytes[1]) << 16 |
           std::uint32_t(bytes[2]) << 8 | bytes[3];
}

/// A chunk of a PNG file: its type of four letters and its data.
struct PngChunk {
    std::string_view type;
    std::span<const std::uint8_t> data;
    std::span<const std::uint8_t> whole;  ///< with length, type and checksum
};

/// Calls visit(chunk) for all chunks of a PNG of encode_png().
template <class Visit>
void for_each_chunk(const Bytes& png, const Visit& visit) {
    for (std::span<const std::uint8_t> rest = std::span(png).subspan(png_signature_size);
         rest.size() >= chunk_frame;) {
        const std::size_t length = number_at(rest);
        visit(PngChunk{{reinterpret_cast<const char*>(&rest[4]), 4},
                       rest.subspan(8, length),
                       rest.first(length + chunk_frame)});
        rest = rest.subspan(length + chunk_frame);
    }
}

class ApngFrames : public FrameWriter {
  public:
    ApngFrames(const std::string& path, const FrameFile& file) : out_(path), file_(file) {}

    void add(const Picture& picture) override {
        const PixelBox box = count_ == 0 ? whole_box(picture) : changed_box(before_, picture);
        before_ = picture;
        const Bytes png = std::visit(
            [](const auto& image) { return encode_png(image, apng_level); }, cut(picture, box));
        if (count_ == 0) out_.write(std::span(png).first(png_signature_size));
        bool told = false;
        for_each_chunk(png, [&](const PngChunk& chunk) {
            if (chunk.type == "IEND") return;
            if (chunk.type != "IDAT") {
                if (count_ == 0) write_other(chunk);
                return;
            }
            if (!std::exchange(told, true)) write_chunk("fcTL", control(box));
            write_data(chunk);
        });
        ++count_;
    }

    void commit() override {
        write_chunk("IEND", {});
        out_.commit();
    }

  private:
    /// Writes a chunk of the first frame that is not its data; acTL follows the header.
    void write_other(const PngChunk& chunk) {
        out_.write(chunk.whole);
        if (chunk.type != "IHDR") return;
        Bytes numbers;
        append_number(numbers, std::uint32_t(file_.frames), 4);
        append_number(numbers, 0, 4);  // plays for ever
        write_chunk("acTL", numbers);
    }

    void write_data(const PngChunk& chunk) {
        if (count_ == 0) return out_.write(chunk.whole);
        Bytes data;
        append_number(data, sequence_++, 4);
        data.insert(data.end(), chunk.data.begin(), chunk.data.end());
        write_chunk("fdAT", data);
    }

    /// The data of a frame's fcTL: its place, which replaces what was there, and its time in
    /// milliseconds.
    Bytes control(const PixelBox& box) {
        Bytes data;
        append_number(data, sequence_++, 4);
        for (const std::size_t number : {box.width, box.height, box.x, box.y})
            append_number(data, std::uint32_t(number), 4);
        append_number(data, std::uint32_t(frame_ticks(count_, file_.rate, 1000)), 2);
        append_number(data, 1000, 2);
        append_number(data, 0, 2);  // left in place afterwards; not blended
        return data;
    }

    void write_chunk(std::string_view type, std::span<const std::uint8_t> data) {
        Bytes chunk;
        append_number(chunk, std::uint32_t(data.size()), 4);
        chunk.insert(chunk.end(), type.begin(), type.end());
        chunk.insert(chunk.end(), data.begin(), data.end());
        const auto checked = std::span(chunk).subspan(4);
        append_number(chunk, std::uint32_t(::crc32(0, checked.data(), ::uInt(checked.size()))), 4);
        out_.write(chunk);
    }

    AtomicFile out_;
    FrameFile file_;
    Picture before_;
    int count_ = 0;
    std::uint32_t sequence_ = 0;
};

}  // namespace

std::unique_ptr<FrameWriter> apng_writer(const std::string& path, const FrameFile& file) {
    return std::make_unique<ApngFrames>(path, file);
}

}  // namespace burl
