#pragma once
// A trial of a bake's costs, for the time that is left: its recipe on a few small squares.
#include <vector>

#include "app/bake/bake.h"

namespace burl {

/// Seconds a texel of what is done to every texel of a bake, by its threads. Zero: not known.
struct TrialCosts {
    double texture = 0.0, levels = 0.0;
    double normals = 0.0;            ///< of one map
    std::vector<double> pictures{};  ///< of each picture, in the order in which they are written
    std::size_t normal_maps = 0;  ///< how often normals are worked out: MIP levels need them, too
};

/// The share of a texture's texels that show something, about.
inline constexpr double usual_coverage = 0.85;

/// The number of threads that the plan's bake has.
double threads_at_work(const BakePlan& plan);

/// The costs of the plan's texture by the pipeline's recipe, its way and its mesh, found by one
/// thread that bakes a small texture over 16 squares, which touch the mesh here and there and are
/// as large as the bake's texels make them. That takes about 1 % of the bake's time; all costs are
/// 0 where the bake is too small for it (least_trial) and where the squares cannot be baked.
TrialCosts try_costs(Pipeline& pipeline, const Recipe& recipe, const BakePlan& plan);

}  // namespace burl
