#include "app/image/exr_layers.h"

#include <algorithm>
#include <cstdint>
#include <set>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>

#include "app/image/exr_stream.h"

namespace burl {
namespace {

/// An image as rows of floats.
struct FloatRows {
    const float* values;
    std::size_t width, height, components;
};

FloatRows rows_of(const FloatImage& any) {
    return std::visit(
        []<class Pixel>(const Image<Pixel>* image) -> FloatRows {
            return {reinterpret_cast<const float*>(image->pixels().data()), image->width(),
                    image->height(), sizeof(Pixel) / sizeof(float)};
        },
        any);
}

Imf::PixelType type_of(ExrDepth depth) {
    return depth == ExrDepth::full ? Imf::FLOAT : Imf::HALF;
}

std::string channel_name(const ExrLayer& layer, std::size_t component) {
    const std::string letter(1, layer.channels[component]);
    return layer.name.empty() ? letter : layer.name + "." + letter;
}

/// Rows of images, one per layer, as a frame buffer of OpenEXR: the floats themselves, or converted
/// to halves.
class LayerRows {
  public:
    /// Row 0 of the images is scan line `line` of the file's level.
    LayerRows(std::span<const ExrLayer> layers, std::span<const FloatImage> images,
              std::size_t line, ExrDepth depth)
        : layers_(layers), images_(images), line_(line), depth_(depth), halves_(layers.size()) {}

    FloatRows whole() const { return rows_of(images_[0]); }

    /// The frame buffer of rows [begin, end) of the images; valid until the next call.
    Imf::FrameBuffer rows(std::size_t begin, std::size_t end) {
        Imf::FrameBuffer frame;
        for (std::size_t l = 0; l < layers_.size(); ++l) insert(frame, l, begin, end);
        return frame;
    }

  private:
    /// Adds a layer's slices. OpenEXR's slices take char* although they are only read here, and are
    /// addressed from scan line 0.
    void insert(Imf::FrameBuffer& frame, std::size_t l, std::size_t begin, std::size_t end) {
        const FloatRows image = rows_of(images_[l]);
        const std::size_t per_row = image.width * image.components;
        const bool full = depth_ == ExrDepth::full;
        if (!full) halves_[l].assign(image.values + begin * per_row, image.values + end * per_row);
        const std::size_t size = full ? sizeof(float) : sizeof(Imath::half);
        const std::size_t stride = size * per_row;
        const auto base =
            full ? reinterpret_cast<std::uintptr_t>(image.values) - line_ * stride
                 : reinterpret_cast<std::uintptr_t>(halves_[l].data()) - (line_ + begin) * stride;
        for (std::size_t c = 0; c < image.components; ++c)
            frame.insert(channel_name(layers_[l], c),
                         Imf::Slice(type_of(depth_), reinterpret_cast<char*>(base + c * size),
                                    size * image.components, stride));
    }

    std::span<const ExrLayer> layers_;
    std::span<const FloatImage> images_;
    std::size_t line_;
    ExrDepth depth_;
    std::vector<std::vector<Imath::half>> halves_;
};

Error misuse(const ExrLayer& layer, const char* what) {
    return Error(ExitCode::runtime, fmt::format("the EXR layer \"{}\" {}", layer.name, what));
}

/// Throws unless the layer's levels are as large as the first layer's.
void check_sizes(const ExrLayer& layer, const ExrLayer& first) {
    if (layer.levels.size() != first.levels.size() || layer.levels.empty())
        throw misuse(layer, "has not as many levels as the first one");
    for (std::size_t l = 0; l < layer.levels.size(); ++l) {
        const FloatRows a = rows_of(layer.levels[l]), b = rows_of(first.levels[l]);
        const FloatRows whole = rows_of(first.levels[0]);
        if (a.width != b.width || a.height != b.height)
            throw misuse(layer, "is not as large as the first one");
        if (b.width != std::max<std::size_t>(whole.width >> l, 1) ||
            b.height != std::max<std::size_t>(whole.height >> l, 1))
            throw misuse(layer, "has levels that do not halve");
    }
}

/// Throws unless the layer has a letter per component, none of which `names` has.
void check_names(const ExrLayer& layer, std::set<std::string>& names) {
    for (const FloatImage& level : layer.levels)
        if (rows_of(level).components != layer.channels.size())
            throw misuse(layer, "has not a letter for every component");
    for (std::size_t c = 0; c < layer.channels.size(); ++c)
        if (!names.insert(channel_name(layer, c)).second)
            throw misuse(layer, "has channels of another one's names");
}

/// The size in pixels of level 0.
struct LayerSize {
    std::size_t width, height;
};

Imf::Header header_of(const LayerSize& size, std::span<const ExrLayer> layers, ExrDepth depth) {
    Imf::Header header(int(size.width), int(size.height));
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const ExrLayer& layer : layers)
        for (std::size_t c = 0; c < layer.channels.size(); ++c)
            header.channels().insert(channel_name(layer, c), Imf::Channel(type_of(depth)));
    return header;
}

void write_lines(Imf::OutputFile& file, LayerRows rows, TaskMeter* meter) {
    const FloatRows whole = rows.whole();
    for (std::size_t y = 0; y < whole.height; y += exr_rows_at_once) {
        const std::size_t end = std::min(y + exr_rows_at_once, whole.height);
        file.setFrameBuffer(rows.rows(y, end));
        file.writePixels(int(end - y));
        if (meter) meter->add((end - y) * whole.width);
    }
}

/// Writes rows of a level, one row of tiles at a time, from tile row `first` on.
void write_tiles(Imf::TiledOutputFile& file, int level, int first, LayerRows rows,
                 TaskMeter* meter) {
    const FloatRows whole = rows.whole();
    for (std::size_t begin = 0; begin < whole.height; begin += exr_tile_side) {
        const std::size_t end = std::min(begin + exr_tile_side, whole.height);
        const int tile = first + int(begin / exr_tile_side);
        file.setFrameBuffer(rows.rows(begin, end));
        file.writeTiles(0, file.numXTiles(level) - 1, tile, tile, level);
        if (meter) meter->add((end - begin) * whole.width);
    }
}

/// How the meter is told of level 0: beside the levels, or by whoever makes its rows.
enum class LevelZero { counted, not_counted };

void encode_lines(Imf::OStream& stream, const LayerSize& size, std::span<const ExrLayer> layers,
                  ExrDepth depth, const LayerRowSource& source, TaskMeter* meter) {
    Imf::OutputFile file(stream, header_of(size, layers, depth));
    source([&](std::span<const FloatImage> rows) {
        write_lines(file, {layers, rows, std::size_t(file.currentScanLine()), depth}, meter);
    });
}

void encode_tiles(Imf::OStream& stream, const LayerSize& size, std::span<const ExrLayer> layers,
                  ExrDepth depth, const LayerRowSource& source, LevelZero zero, TaskMeter* meter) {
    Imf::Header header = header_of(size, layers, depth);
    header.setTileDescription({exr_tile_side, exr_tile_side, Imf::MIPMAP_LEVELS, Imf::ROUND_DOWN});
    Imf::TiledOutputFile file(stream, header);
    std::size_t line = 0;
    const auto images = source([&](std::span<const FloatImage> rows) {
        const std::size_t end = line + rows_of(rows[0]).height;
        if (end % exr_tile_side != 0 && end != size.height)
            throw misuse(layers[0], "comes in rows of half a tile");
        write_tiles(file, 0, int(line / exr_tile_side), {layers, rows, line, depth},
                    zero == LevelZero::counted ? meter : nullptr);
        line = end;
    });
    if (images.size() != layers.size()) throw misuse(layers[0], "has other levels than layers");
    for (const std::vector<FloatImage>& levels : images)
        if (levels.size() + 1 != std::size_t(file.numLevels()))
            throw misuse(layers[0], "does not have all levels down to 1 x 1");
    for (int l = 1; l < file.numLevels(); ++l) {
        std::vector<FloatImage> level;
        for (const std::vector<FloatImage>& levels : images)
            level.push_back(levels[std::size_t(l - 1)]);
        write_tiles(file, l, 0, {layers, level, 0, depth}, meter);
    }
}

}  // namespace

AtomicFile write_exr_layers(const std::string& path, std::span<const ExrLayer> layers,
                            ExrDepth depth, TaskMeter* meter) {
    std::set<std::string> names;
    for (const ExrLayer& layer : layers) {
        check_sizes(layer, layers[0]);
        check_names(layer, names);
    }
    const LayerRowSource source = [&](const LayerRowSink& sink) {
        std::vector<FloatImage> whole;
        std::vector<std::vector<FloatImage>> levels;
        for (const ExrLayer& layer : layers) {
            whole.push_back(layer.levels[0]);
            levels.emplace_back(layer.levels.begin() + 1, layer.levels.end());
        }
        sink(whole);
        return levels;
    };
    const FloatRows whole = rows_of(layers[0].levels[0]);
    const LayerSize size{whole.width, whole.height};
    return write_exr_stream(
        path, "OpenEXR image", size.width, size.height, [&](Imf::OStream& stream) {
            layers[0].levels.size() > 1
                ? encode_tiles(stream, size, layers, depth, source, LevelZero::counted, meter)
                : encode_lines(stream, size, layers, depth, source, meter);
        });
}

AtomicFile write_exr_layers(const std::string& path, std::size_t size,
                            std::span<const ExrLayer> layers, const LayerRowSource& source,
                            bool has_levels, ExrDepth depth, TaskMeter* meter) {
    std::set<std::string> names;
    for (const ExrLayer& layer : layers) check_names(layer, names);
    return write_exr_stream(path, "OpenEXR image", size, size, [&](Imf::OStream& stream) {
        has_levels ? encode_tiles(stream, {size, size}, layers, depth, source,
                                  LevelZero::not_counted, meter)
                   : encode_lines(stream, {size, size}, layers, depth, source, nullptr);
    });
}

}  // namespace burl
