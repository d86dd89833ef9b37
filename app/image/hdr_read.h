#pragma once
// Radiance pictures (.hdr): red, green and blue with one exponent (Ward, "Real Pixels", 1991).
#include <string>

#include "atlas/base/image.h"

namespace burl {

/// The linear light of a Radiance picture, row 0 on top, divided by the exposures that its header
/// states. Relative error 2^-8. Throws Error: io, invalid_file (no such picture, damaged,
/// truncated, over 2^27 pixels), unsupported (XYZE, rows in another order than from the top left).
Image<RgbF> read_hdr(const std::string& path);

}  // namespace burl
