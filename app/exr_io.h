#pragma once
// OpenEXR output for float images: linear light, as the format wants it.
#include <cstdint>
#include <string>
#include <vector>

#include "atlas/image.h"

namespace burl {

enum class ExrDepth {
    half,       ///< 16-bit floats: 11 significant bits, relative error 2^-11
    float_full  ///< 32-bit floats, bit-exact
};

/// EXR file content: channels R, G, B of linear light (Rec. 709 primaries, the format's default),
/// row 0 on top, ZIP-compressed. The image has at least one pixel. Throws Error(runtime) when
/// OpenEXR cannot encode it.
std::vector<std::uint8_t> encode_exr(const Image<RgbF>& image, ExrDepth depth = ExrDepth::half);

/// Writes the file whole or not at all. Throws Error(io).
void write_exr(const std::string& path, const Image<RgbF>& image, ExrDepth depth = ExrDepth::half);

}  // namespace burl
