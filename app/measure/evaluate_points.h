#pragma once
// The evaluations that `burl eval` prints: recipes and noises at given points, in float64 and
// another precision.
#include <optional>
#include <vector>

#include "app/measure/point_file.h"
#include "app/options/noise_options.h"
#include "app/recipe/recipe.h"
#include "procedural/batch/precision.h"

namespace burl {

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
/// luminance. Throws Error: usage for points that are not x,y,z, and as check_lattice does.
std::vector<PointResult> evaluate_points(const Recipe& recipe, const PointFile& file);

}  // namespace burl
