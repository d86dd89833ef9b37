#pragma once
// OpenEXR output for float images: linear light, as the format wants it.
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/base/atomic_file.h"
#include "atlas/base/image.h"

namespace burl {

enum class ExrDepth {
    half,       ///< 16-bit floats: 11 significant bits, relative error 2^-11
    float_full  ///< 32-bit floats, bit-exact
};

/// Writes an EXR file: channels R, G, B of linear light (Rec. 709 primaries, the format's default),
/// row 0 on top, ZIP-compressed, row by row into the file: nothing as large as the image is made.
/// The image has at least one pixel. The file is complete and has yet to be committed. Throws
/// Error(io), and Error(runtime) when OpenEXR cannot encode it.
AtomicFile write_exr(const std::string& path, const Image<RgbF>& image,
                     ExrDepth depth = ExrDepth::half);

/// Takes rows of an image, the next ones at each call; and what hands them all over.
using RowSink = std::function<void(const Image<RgbF>& rows)>;
using RowSource = std::function<void(const RowSink&)>;

/// The same of an image of `width` x `height` pixels that need not be there as a whole.
AtomicFile write_exr_rows(const std::string& path, std::size_t width, std::size_t height,
                          const RowSource& source, ExrDepth depth = ExrDepth::half);

/// Hands over the rows of an image, and then gives its levels 1, 2, ...
using LevelSource = std::function<std::vector<Image<RgbF>>(const RowSink&)>;

/// The same with MIP levels: `levels[l]` is level l, of max(1, floor(n / 2^l)) pixels a side; tiles
/// of 64 x 64, MIPMAP_LEVELS rounded down. All levels down to 1 x 1 must be there.
AtomicFile write_exr_levels(const std::string& path, std::span<const Image<RgbF>* const> levels,
                            ExrDepth depth = ExrDepth::half);
AtomicFile write_exr_levels(const std::string& path, std::size_t width, std::size_t height,
                            const LevelSource& source, ExrDepth depth = ExrDepth::half);

}  // namespace burl
