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

/// Rows of one level of all layers as a frame buffer of OpenEXR: the floats themselves, or
/// converted to halves.
class LayerRows {
  public:
    LayerRows(std::span<const ExrLayer> layers, std::size_t level, ExrDepth depth)
        : layers_(layers), level_(level), depth_(depth), halves_(layers.size()) {}

    /// The frame buffer of rows [begin, end); valid until the next call.
    Imf::FrameBuffer rows(std::size_t begin, std::size_t end) {
        Imf::FrameBuffer frame;
        for (std::size_t l = 0; l < layers_.size(); ++l) insert(frame, l, begin, end);
        return frame;
    }

  private:
    /// Adds a layer's slices. OpenEXR's slices take char* although they are only read here, and are
    /// addressed from scan line 0.
    void insert(Imf::FrameBuffer& frame, std::size_t l, std::size_t begin, std::size_t end) {
        const FloatRows image = rows_of(layers_[l].levels[level_]);
        const std::size_t per_row = image.width * image.components;
        const bool full = depth_ == ExrDepth::full;
        if (!full) halves_[l].assign(image.values + begin * per_row, image.values + end * per_row);
        const std::size_t size = full ? sizeof(float) : sizeof(Imath::half);
        const std::size_t stride = size * per_row;
        const auto base =
            full ? reinterpret_cast<std::uintptr_t>(image.values)
                 : reinterpret_cast<std::uintptr_t>(halves_[l].data()) - begin * stride;
        for (std::size_t c = 0; c < image.components; ++c)
            frame.insert(channel_name(layers_[l], c),
                         Imf::Slice(type_of(depth_), reinterpret_cast<char*>(base + c * size),
                                    size * image.components, stride));
    }

    std::span<const ExrLayer> layers_;
    std::size_t level_;
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

Imf::Header header_of(std::span<const ExrLayer> layers, ExrDepth depth) {
    const FloatRows whole = rows_of(layers[0].levels[0]);
    Imf::Header header(int(whole.width), int(whole.height));
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const ExrLayer& layer : layers)
        for (std::size_t c = 0; c < layer.channels.size(); ++c)
            header.channels().insert(channel_name(layer, c), Imf::Channel(type_of(depth)));
    return header;
}

void encode_lines(Imf::OStream& stream, std::span<const ExrLayer> layers, ExrDepth depth,
                  TaskMeter* meter) {
    Imf::OutputFile file(stream, header_of(layers, depth));
    LayerRows rows(layers, 0, depth);
    const FloatRows whole = rows_of(layers[0].levels[0]);
    for (std::size_t y = 0; y < whole.height; y += exr_rows_at_once) {
        const std::size_t end = std::min(y + exr_rows_at_once, whole.height);
        file.setFrameBuffer(rows.rows(y, end));
        file.writePixels(int(end - y));
        if (meter) meter->add((end - y) * whole.width);
    }
}

/// Writes a level, one row of tiles at a time; tiles' frame buffers begin at the level's own rows.
void write_level(Imf::TiledOutputFile& file, std::span<const ExrLayer> layers, int level,
                 ExrDepth depth, TaskMeter* meter) {
    LayerRows rows(layers, std::size_t(level), depth);
    const FloatRows whole = rows_of(layers[0].levels[std::size_t(level)]);
    for (int tile = 0; tile < file.numYTiles(level); ++tile) {
        const std::size_t begin = exr_tile_side * std::size_t(tile);
        const std::size_t end = std::min(begin + exr_tile_side, whole.height);
        file.setFrameBuffer(rows.rows(begin, end));
        file.writeTiles(0, file.numXTiles(level) - 1, tile, tile, level);
        if (meter) meter->add((end - begin) * whole.width);
    }
}

void encode_tiles(Imf::OStream& stream, std::span<const ExrLayer> layers, ExrDepth depth,
                  TaskMeter* meter) {
    Imf::Header header = header_of(layers, depth);
    header.setTileDescription({exr_tile_side, exr_tile_side, Imf::MIPMAP_LEVELS, Imf::ROUND_DOWN});
    Imf::TiledOutputFile file(stream, header);
    if (std::size_t(file.numLevels()) != layers[0].levels.size())
        throw misuse(layers[0], "does not have all levels down to 1 x 1");
    for (int l = 0; l < file.numLevels(); ++l) write_level(file, layers, l, depth, meter);
}

}  // namespace

AtomicFile write_exr_layers(const std::string& path, std::span<const ExrLayer> layers,
                            ExrDepth depth, TaskMeter* meter) {
    std::set<std::string> names;
    for (const ExrLayer& layer : layers) {
        check_sizes(layer, layers[0]);
        check_names(layer, names);
    }
    const FloatRows whole = rows_of(layers[0].levels[0]);
    return write_exr_stream(path, "OpenEXR image", whole.width, whole.height,
                            [&](Imf::OStream& stream) {
                                const bool tiled = layers[0].levels.size() > 1;
                                tiled ? encode_tiles(stream, layers, depth, meter)
                                      : encode_lines(stream, layers, depth, meter);
                            });
}

}  // namespace burl
