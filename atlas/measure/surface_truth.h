#pragma once
// What every level of a perfect texture would show at points of the surface. It depends on the mesh
// and the texture's size only, so that one truth serves all atlases.
#include <vector>

#include "atlas/measure/surface_mean.h"

namespace burl {

/// Length over width of a grazing footprint.
inline constexpr double grazing_stretch = 8.0;

struct TruthOptions {
    std::uint32_t size = 1024;         ///< N of the textures to be judged
    std::size_t level_points = 20000;  ///< points for levels 1 and up
    std::size_t points = 150000;       ///< points for level 0
    std::size_t grazing_points = 5000;
    std::uint32_t levels = 6;          ///< last level
    std::uint32_t first_level = 1;     ///< levels before it get no means
    std::uint32_t grazing_levels = 3;  ///< last level with grazing footprints, if it is of 32
                                       ///< texels a side: each way they end 10.4 texels away
    double detail = 1.0 / 40;          ///< size of f's finest detail (surface_mean.h)
    std::uint64_t seed = 1;
};

struct LevelTruth {
    std::vector<Vec3d> means;  ///< per point: mean of two quadratures
    double noise = 0.0;  ///< RMS error of these means, half the two quadratures' RMS difference
};

/// Unit directions in the plane of a point's triangle, at right angles.
struct FootprintAxes {
    Vec3d along{0.0}, across{0.0};
};

/// Footprints sigma wide across and 8 sigma long along their axes.
struct GrazingTruth {
    std::vector<SurfacePoint> points;
    std::vector<FootprintAxes> axes;  ///< per point, in a random direction
    std::vector<LevelTruth> levels;   ///< [l-1] is level l
};

struct SurfaceTruth {
    std::vector<SurfacePoint> points;
    std::vector<Vec3d> values;  ///< f at `points`
    std::vector<SurfacePoint> level_points;
    std::vector<LevelTruth> levels;  ///< [l-1] is level l: sigma = 2^(l-1) texel
    double texel = 0.0;              ///< sqrt(area) / N, mesh units
    GrazingTruth grazing;
};

/// Levels the texture does not have are left out. The mesh's coordinates are of the order of 1.
SurfaceTruth surface_truth(const Mesh& mesh, const SolidColor& f, const TruthOptions& options);

}  // namespace burl
