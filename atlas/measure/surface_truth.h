#pragma once
// The colours that every level of a perfect texture would show at points of the surface. They
// depend on the mesh and the texture's size only, so that one truth serves all atlases.
#include <vector>

#include "atlas/measure/sampled_views.h"
#include "atlas/measure/surface_mean.h"

namespace burl {

/// Length over width of a grazing footprint.
inline constexpr double grazing_stretch = 8.0;

/// Size of the textures to be judged, and the number of points and levels.
struct TruthOptions {
    std::uint32_t size = 1024;          ///< N, the side of the textures to be judged
    std::size_t level_points = 20000;   ///< number of points for levels 1 and up
    std::size_t points = 150000;        ///< number of points for level 0
    std::size_t grazing_points = 5000;  ///< number of points for grazing footprints
    std::uint32_t levels = 6;           ///< last level
    std::uint32_t first_level = 1;      ///< levels before this one get no means
    /// Last level with grazing footprints; levels of less than 32 texels a side get none, as a
    /// footprint ends 10.4 texels away either way.
    std::uint32_t grazing_levels = 3;
    double detail = 1.0 / 40;  ///< size of f's finest detail (surface_mean.h)
    std::uint64_t seed = 1;
    std::size_t view_points = 0;  ///< number of pixels of every row of sampled views
};

/// The colours of one level at its points.
struct LevelTruth {
    std::vector<Vec3d> means;  ///< mean of two quadratures at each point
    /// RMS error of the means: half the RMS difference of the two quadratures.
    double noise = 0.0;
};

/// Truth for grazing footprints, sigma wide across and 8 sigma long along their axes.
struct GrazingTruth {
    std::vector<SurfacePoint> points;
    std::vector<FootprintAxes> axes;  ///< axes of each point's footprint, turned at random
    std::vector<LevelTruth> levels;   ///< levels[l-1] is level l
};

/// The truth of all levels.
struct SurfaceTruth {
    std::vector<SurfacePoint> points;
    std::vector<Vec3d> values;  ///< level 0: f at `points`
    std::vector<SurfacePoint> level_points;
    std::vector<LevelTruth> levels;  ///< levels[l-1] is level l: sigma = 2^(l-1) texel
    double texel = 0.0;              ///< sqrt(area) / N in mesh units
    GrazingTruth grazing;
    SampledViews views;
};

/// The truth of a texture f on the mesh's surface. Levels that the texture does not have are left
/// out. The mesh's coordinates are of the order of 1.
SurfaceTruth surface_truth(const Mesh& mesh, const SolidColor& f, const TruthOptions& options);

/// About the number of calls of f by surface_truth(): rather more than fewer.
double truth_calls(const Mesh& mesh, const TruthOptions& options);

}  // namespace burl
