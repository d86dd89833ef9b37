#pragma once
// OpenEXR files. Images hold linear light, as the format defines, in half floats (16 bits with 11
// significant ones, relative error 2^-11) or in floats. Every file is complete but not committed
// when it is returned.
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/base/atomic_file.h"
#include "atlas/base/image.h"

namespace burl {

/// The kind of an .exr's numbers: 16 bits, or 32, which keep every bit of what was computed.
enum class ExrDepth { half, full };

/// Writes a scan-line EXR file: channels R, G, B of linear light (Rec. 709 primaries, the format's
/// default), row 0 on top, ZIP-compressed, at most 256 rows at a time, so that no copy of the image
/// is made. The image has at least one pixel. Throws Error(io), and Error(runtime) where OpenEXR
/// cannot encode it.
AtomicFile write_exr(const std::string& path, const Image<RgbF>& image,
                     ExrDepth depth = ExrDepth::half);

/// Receives the next rows of an image at each call, from the top down.
using RowSink = std::function<void(const Image<RgbF>& rows)>;
/// Produces an image by passing all its rows to the sink.
using RowSource = std::function<void(const RowSink&)>;

/// Writes a scan-line EXR file of `width` x `height` pixels as write_exr() does, from rows that
/// need not be in memory together.
AtomicFile write_exr_rows(const std::string& path, std::size_t width, std::size_t height,
                          const RowSource& source, ExrDepth depth = ExrDepth::half);

/// Passes all rows of an image to the sink and then returns its MIP levels 1, 2, ...
using LevelSource = std::function<std::vector<Image<RgbF>>(const RowSink&)>;

/// Writes a tiled EXR file with MIP levels: `levels[l]` is level l, of max(1, floor(n / 2^l))
/// pixels a side; tiles of 64 x 64, MIPMAP_LEVELS rounded down. All levels down to 1 x 1 must be
/// given. Errors are those of write_exr().
AtomicFile write_exr_levels(const std::string& path, std::span<const Image<RgbF>* const> levels,
                            ExrDepth depth = ExrDepth::half);
/// Writes a tiled EXR file of `width` x `height` pixels whose level 0 comes in rows, so that it
/// need not be in memory as a whole.
AtomicFile write_exr_levels(const std::string& path, std::size_t width, std::size_t height,
                            const LevelSource& source, ExrDepth depth = ExrDepth::half);

}  // namespace burl
