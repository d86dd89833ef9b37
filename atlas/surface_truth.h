#pragma once
// What every level of a perfect texture would show at points of the surface. It depends on the mesh
// and the texture's size only, so that one truth serves all atlases.
#include <vector>

#include "atlas/surface_mean.h"

namespace burl {

struct TruthOptions {
    std::uint32_t size = 1024;         ///< N of the textures to be judged
    std::size_t level_points = 20000;  ///< points for levels 1 and up
    std::size_t points = 150000;       ///< points for level 0
    std::uint32_t levels = 6;          ///< last level
    double detail = 1.0 / 40;          ///< size of f's finest detail (surface_mean.h)
    std::uint64_t seed = 1;
};

struct LevelTruth {
    std::vector<double> means;  ///< per level point: mean of two quadratures
    double noise = 0.0;  ///< RMS error of these means, half the two quadratures' RMS difference
};

struct SurfaceTruth {
    std::vector<SurfacePoint> points;
    std::vector<double> values;  ///< f at `points`
    std::vector<SurfacePoint> level_points;
    std::vector<LevelTruth> levels;  ///< [l-1] is level l: sigma = 2^(l-1) sqrt(area) / N
};

/// Levels the texture does not have are left out. The mesh's coordinates are of the order of 1.
SurfaceTruth surface_truth(const Mesh& mesh, const SolidFunction& f, const TruthOptions& options);

}  // namespace burl
