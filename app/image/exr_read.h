#pragma once
// OpenEXR pictures of light, read back.
#include <string>

#include "atlas/base/image.h"

namespace burl {

/// The linear light of an OpenEXR file's first part: channels R, G, B, or Y as grey, of halves or
/// floats, in lines or tiles (level 0), row 0 on top, within its data window. Throws Error: io,
/// invalid_file (no such file, damaged, truncated, over 2^27 pixels), unsupported (other channels).
Image<RgbF> read_exr(const std::string& path);

}  // namespace burl
