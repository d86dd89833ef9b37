#include "app/image/exr_io.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>

#include "app/image/exr_stream.h"

namespace burl {
namespace {

constexpr const char* what_it_is = "OpenEXR image";  ///< in errors
constexpr const char* channels[] = {"R", "G", "B"};

/// Rows of an image as a frame buffer of OpenEXR: the floats themselves, or converted to halves.
class ExrRows {
  public:
    ExrRows(const Image<RgbF>& image, ExrDepth depth) : image_(image), depth_(depth) {}

    /// The frame buffer of rows [begin, end) of an image whose row 0 is scan line `line` of the
    /// file; valid until the next call.
    Imf::FrameBuffer rows(std::size_t begin, std::size_t end, std::size_t line = 0) {
        if (depth_ == ExrDepth::full)
            return frame(&image_(0, begin), Imf::FLOAT, sizeof(float), line + begin);
        halves_.clear();
        for (std::size_t y = begin; y < end; ++y)
            for (const RgbF& p : image_.row(y))
                halves_.push_back({Imath::half(p.r), Imath::half(p.g), Imath::half(p.b)});
        return frame(halves_.data(), Imf::HALF, sizeof(Imath::half), line + begin);
    }

  private:
    /// A frame buffer whose pixels begin at scan line `first`. OpenEXR's slices take char* although
    /// they are only read here, and are addressed from scan line 0.
    Imf::FrameBuffer frame(const void* pixels, Imf::PixelType type, std::size_t size,
                           std::size_t first) const {
        const std::size_t step = 3 * size, stride = step * image_.width();
        const auto base = reinterpret_cast<std::uintptr_t>(pixels) - first * stride;
        Imf::FrameBuffer frame;
        for (std::size_t c = 0; c < 3; ++c)
            frame.insert(channels[c],
                         Imf::Slice(type, reinterpret_cast<char*>(base + c * size), step, stride));
        return frame;
    }

    const Image<RgbF>& image_;
    ExrDepth depth_;
    std::vector<Rgb<Imath::half>> halves_;
};

Imf::Header header_of(std::size_t width, std::size_t height, ExrDepth depth) {
    Imf::Header header(static_cast<int>(width), static_cast<int>(height));
    header.compression() = Imf::ZIP_COMPRESSION;
    const Imf::PixelType type = depth == ExrDepth::full ? Imf::FLOAT : Imf::HALF;
    for (const char* name : channels) header.channels().insert(name, Imf::Channel(type));
    return header;
}

/// Writes a whole level, one row of tiles at a time.
void write_level(Imf::TiledOutputFile& file, int level, const Image<RgbF>& image, ExrDepth depth) {
    ExrRows rows(image, depth);
    for (int tile = 0; tile < file.numYTiles(level); ++tile) {
        const std::size_t begin = exr_tile_side * std::size_t(tile);
        file.setFrameBuffer(rows.rows(begin, std::min(begin + exr_tile_side, image.height())));
        file.writeTiles(0, file.numXTiles(level) - 1, tile, tile, level);
    }
}

Imf::Header tiled_header(std::size_t width, std::size_t height, ExrDepth depth) {
    Imf::Header header = header_of(width, height, depth);
    header.setTileDescription({exr_tile_side, exr_tile_side, Imf::MIPMAP_LEVELS, Imf::ROUND_DOWN});
    return header;
}

void encode_levels(Imf::OStream& stream, std::span<const Image<RgbF>* const> levels,
                   ExrDepth depth) {
    Imf::TiledOutputFile file(stream, tiled_header(levels[0]->width(), levels[0]->height(), depth));
    for (int l = 0; l < file.numLevels(); ++l) write_level(file, l, *levels[std::size_t(l)], depth);
}

/// Collects rows of level 0 and writes each row of tiles once all its rows are there.
class TileRows {
  public:
    TileRows(Imf::TiledOutputFile& file, std::size_t width, std::size_t height, ExrDepth depth)
        : file_(file), height_(height), depth_(depth), rows_(width, exr_tile_side) {}

    void add(const Image<RgbF>& rows) {
        for (std::size_t y = 0; y < rows.height(); ++y) {
            std::ranges::copy(rows.row(y), rows_.row(next_ % exr_tile_side).begin());
            if (++next_ % exr_tile_side == 0 || next_ == height_) write();
        }
    }

  private:
    void write() {
        const std::size_t tile = (next_ - 1) / exr_tile_side, begin = tile * exr_tile_side;
        ExrRows rows(rows_, depth_);
        file_.setFrameBuffer(rows.rows(0, next_ - begin, begin));
        file_.writeTiles(0, file_.numXTiles(0) - 1, int(tile), int(tile), 0);
    }

    Imf::TiledOutputFile& file_;
    std::size_t height_, next_ = 0;
    ExrDepth depth_;
    Image<RgbF> rows_;
};

/// Writes the rows at the file's current scan line.
void write_rows(Imf::OutputFile& file, const Image<RgbF>& image, ExrDepth depth) {
    ExrRows rows(image, depth);
    const auto line = std::size_t(file.currentScanLine());
    for (std::size_t y = 0; y < image.height(); y += exr_rows_at_once) {
        const std::size_t end = std::min(y + exr_rows_at_once, image.height());
        file.setFrameBuffer(rows.rows(y, end, line));
        file.writePixels(int(end - y));
    }
}

}  // namespace

AtomicFile write_exr_rows(const std::string& path, std::size_t width, std::size_t height,
                          const RowSource& source, ExrDepth depth) {
    return write_exr_stream(path, what_it_is, width, height, [&](Imf::OStream& stream) {
        Imf::OutputFile file(stream, header_of(width, height, depth));
        source([&](const Image<RgbF>& rows) { write_rows(file, rows, depth); });
    });
}

AtomicFile write_exr(const std::string& path, const Image<RgbF>& image, ExrDepth depth) {
    const auto whole = [&](const RowSink& sink) { sink(image); };
    return write_exr_rows(path, image.width(), image.height(), whole, depth);
}

AtomicFile write_exr_levels(const std::string& path, std::span<const Image<RgbF>* const> levels,
                            ExrDepth depth) {
    return write_exr_stream(path, what_it_is, levels[0]->width(), levels[0]->height(),
                            [&](Imf::OStream& stream) { encode_levels(stream, levels, depth); });
}

AtomicFile write_exr_levels(const std::string& path, std::size_t width, std::size_t height,
                            const LevelSource& source, ExrDepth depth) {
    return write_exr_stream(path, what_it_is, width, height, [&](Imf::OStream& stream) {
        Imf::TiledOutputFile file(stream, tiled_header(width, height, depth));
        TileRows tiles(file, width, height, depth);
        const std::vector<Image<RgbF>> levels =
            source([&](const Image<RgbF>& rows) { tiles.add(rows); });
        for (std::size_t l = 0; l < levels.size(); ++l)
            write_level(file, int(l + 1), levels[l], depth);
    });
}

}  // namespace burl
