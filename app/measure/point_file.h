#pragma once
// Points as comma-separated text (CSV), as other programs and spreadsheets write it.
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace burl {

/// Points of one to four coordinates; unused coordinates are 0.
struct PointFile {
    std::size_t dimensions = 3;  ///< the number of coordinates of all points, 1 to 4
    std::vector<std::array<double, 4>> points;
};

/// Reads lines of one to four numbers, the same number in each. Empty lines and lines that begin
/// with # are skipped. A first line that does not begin with a number names the columns; then x, y,
/// z and w are read and all others ignored. Throws Error: io when the file cannot be read,
/// invalid_file "file:line: ..." for a line that is not a point, a number that is not finite, or a
/// file without points.
PointFile read_points(const std::string& path);

}  // namespace burl
