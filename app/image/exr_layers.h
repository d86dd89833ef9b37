#pragma once
// OpenEXR files of several images: a material's channels beside one another, or one image with
// opacity. Halves or floats as in exr_io.h; colours with opacity are premultiplied, as the format
// defines.
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "app/base/atomic_file.h"
#include "app/image/exr_io.h"
#include "atlas/base/image.h"
#include "atlas/base/task_meter.h"

namespace burl {

/// An image of one to four floats a pixel, which outlives its use.
using FloatImage = std::variant<const Image<float>*, const Image<RgbF>*, const Image<RgbaF>*>;

/// An image of a file, with its MIP levels.
struct ExrLayer {
    /// The layer's name, such as "metallic" or "coat.normal"; empty for the file's main image.
    std::string name{};
    /// A letter per component of the pixels, which with the name makes a channel's name: "RGB",
    /// "RGBA", "XYZ" (a normal), "Y" (a number, "metallic.Y").
    std::string channels = "RGB";
    /// Level 0 alone or all levels down to 1 x 1, of max(1, floor(n / 2^l)) pixels a side.
    std::vector<FloatImage> levels{};
};

/// Writes an EXR file of at least one layer, ZIP-compressed: scan lines, or tiles of 64 x 64 with
/// MIPMAP_LEVELS rounded down where layers have several levels. All layers have the same sizes.
/// Throws Error(io), and Error(runtime) where two channels have one name, a layer has not as many
/// letters as components, sizes differ, or OpenEXR cannot encode it. The file is complete but not
/// committed. A meter gets the texels of all levels, once for all layers, as they are written.
AtomicFile write_exr_layers(const std::string& path, std::span<const ExrLayer> layers,
                            ExrDepth depth = ExrDepth::half, TaskMeter* meter = nullptr);

/// Takes the next rows of all layers' level 0, an image per layer.
using LayerRowSink = std::function<void(std::span<const FloatImage> rows)>;
/// Passes all rows of level 0 to the sink, from the top down, in bands of a multiple of 64 rows but
/// for the last, and then returns each layer's MIP levels 1, 2, ..., which outlive the writing;
/// nothing for a file without levels.
using LayerRowSource = std::function<std::vector<std::vector<FloatImage>>(const LayerRowSink&)>;

/// Writes the same file of `size` x `size` pixels from rows that need not be in memory together;
/// the layers have no levels of their own. The meter gets the texels of levels above level 0.
AtomicFile write_exr_layers(const std::string& path, std::size_t size,
                            std::span<const ExrLayer> layers, const LayerRowSource& source,
                            bool has_levels, ExrDepth depth = ExrDepth::half,
                            TaskMeter* meter = nullptr);

}  // namespace burl
