#pragma once
// What `burl eval` prints: recipes and noises at given points, in float64 and another precision.
#include <optional>
#include <vector>

#include "app/measure/point_file.h"
#include "app/options/noise_options.h"
#include "app/recipe/recipe.h"
#include "procedural/batch/precision.h"

namespace burl {

/// What one precision gives at a point.
struct Evaluation {
    double value = 0.0;
    std::vector<double> gradient;  ///< one for each coordinate; none in fixed point
    std::optional<Vec3d> color;    ///< linear light, of recipes
};

struct PointResult {
    Evaluation float64;
    std::optional<Evaluation> other;  ///< float32 unless another precision is asked for
};

/// Throws Error(usage) for dimensions, periods and precisions that the noise does not have.
std::vector<PointResult> evaluate_points(NoiseOptions noise, const PointFile& file,
                                         const Precision& precision);

/// f, its gradient with respect to the point in solid space (before the recipe's scale) and the
/// colour, in the recipe's precision besides float64. float32: noise in float32 and the sum in
/// float64, as a bake has it, then rounded. Throws Error(usage) for points that are not x,y,z,
/// and as check_lattice does.
/// Graphs: float64, and that rounded; of a colour the luminance.
std::vector<PointResult> evaluate_points(const Recipe& recipe, const PointFile& file);

}  // namespace burl
