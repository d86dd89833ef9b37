#pragma once
// What `burl eval` prints: recipes and noises at given points, in every precision there is.
#include <optional>
#include <vector>

#include "app/noise_options.h"
#include "app/point_file.h"
#include "app/recipe.h"
#include "procedural/fixed_noise.h"

namespace burl {

/// What one precision gives at a point.
struct Evaluation {
    double value = 0.0;
    std::vector<double> gradient;  ///< one for each coordinate; none in fixed point
    std::optional<Vec3d> color;    ///< linear light, of recipes
};

struct PointResult {
    Evaluation float64, float32;
    std::optional<Evaluation> fixed;  ///< where a format was asked for
};

/// Throws Error(usage) for dimensions, periods and formats that the noise does not have.
std::vector<PointResult> evaluate_points(NoiseOptions noise, const PointFile& file,
                                         const std::optional<FixedFormat>& format);

/// f, its gradient with respect to the point in solid space (before the recipe's scale) and the
/// colour. float32: noise in float32 and the sum in float64, as a bake has it, then rounded. Fixed:
/// noise in fixed point, the rest in float64. Throws Error(usage) for points that are not x,y,z and
/// for noises without fixed point. Graphs: float64, and that rounded; of a colour the luminance; no
/// fixed point.
std::vector<PointResult> evaluate_points(const Recipe& recipe, const PointFile& file,
                                         const std::optional<FixedFormat>& format);

}  // namespace burl
