#pragma once
// Points as comma-separated text, the way other programs and spreadsheets write them.
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace burl {

struct PointFile {
    std::size_t dimensions = 3;  ///< 1 to 4: how many of the coordinates are there
    std::vector<std::array<double, 4>> points;
};

/// Reads lines of one to four numbers, the same number in each. Empty lines and lines that begin
/// with # are skipped. A first line that is no numbers names the columns; then x, y, z and w are
/// taken and all others ignored. Throws Error(io) when the file cannot be read, and "file:line:
/// ..." for what is no point, not finite, or for a file without points.
PointFile read_points(const std::string& path);

}  // namespace burl
