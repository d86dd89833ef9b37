#pragma once
// The evaluations that `burl eval` prints: recipes and noises at given points, in float64 and
// another precision.
#include <array>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/options/noise_options.h"
#include "app/recipe/recipe.h"
#include "procedural/batch/precision.h"

namespace burl {

/// Points of one to four coordinates; unused coordinates are 0.
struct PointFile {
    std::size_t dimensions = 3;  ///< the number of coordinates of all points, 1 to 4
    std::vector<std::array<double, 4>> points;
};

/// Reads comma-separated text (CSV), as other programs and spreadsheets write it: lines of one to
/// four numbers, the same number in each. Empty lines and lines that begin with # are skipped. A
/// first line that does not begin with a number names the columns; then x, y, z and w are read and
/// all others ignored. Throws Error: io when the file cannot be read, invalid_file "file:line: ..."
/// for a line that is not a point, a number that is not finite, or a file without points.
PointFile read_points(const std::string& path);

/// The value of a recipe or noise at a point in one precision.
struct Evaluation {
    double value = 0.0;
    std::vector<double> gradient;  ///< one derivative per coordinate; empty in fixed point
    std::optional<Vec3d> color;    ///< the colour in linear light, for recipes
};

/// The evaluations at one point.
struct PointResult {
    Evaluation float64;
    /// The evaluation in float32 unless another precision is asked for; none for float64.
    std::optional<Evaluation> other;
};

/// Evaluates the noise at the file's points. Throws Error: usage for dimensions, periods and
/// precisions that the noise does not have, unsupported for lattice coordinates beyond
/// farthest_cell.
std::vector<PointResult> evaluate_points(NoiseOptions noise, const PointFile& file,
                                         const Precision& precision);

/// Evaluates f, its gradient with respect to the point in solid space (before the recipe's scale)
/// and the colour, in float64 and the recipe's precision. float32 means noise in float32 and the
/// sum in float64, as in a bake, then rounded. The value of a graph that gives a colour is its
/// luminance. Masks of the shape are those of `mesh` at its points nearest to the file's. Throws
/// Error: usage for points that are not x,y,z, unsupported for a texture that reads a mask where
/// `mesh` is null, runtime soon after `stop` is requested, and as check_lattice does.
std::vector<PointResult> evaluate_points(const Recipe& recipe, const PointFile& file,
                                         const Mesh* mesh = nullptr,
                                         const std::stop_token& stop = {});

}  // namespace burl
