#pragma once
// How time and memory of a bake grow: its stages on meshes and textures of sizes in a geometric
// series, and the exponent by which their time grows, which is 1 where it is linear.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace burl {

/// One run of a stage.
struct ScalePoint {
    double units = 0.0;    ///< triangles or texels
    double seconds = 0.0;  ///< of processor, all threads together: other programs do not count
    /// Most memory resident in the process while the stage ran, with its input, less what there was
    /// before the mesh was made; 0 where the system does not tell.
    double peak_bytes = 0.0;
};

/// A stage at every size of a series.
struct ScaleSeries {
    std::string stage;  ///< such as "quad layout" or "write"
    std::string unit;   ///< "triangle" or "texel"
    std::vector<ScalePoint> points{};

    /// The exponent of the time: the slope of log(seconds) over log(units) by least squares.
    double exponent() const;
    /// Peak memory from the smallest size to the largest, over their difference in units: what a
    /// unit more takes, without what every bake takes.
    double bytes_per_unit() const;
};

/// The slope of log(y) over log(x) by least squares, of at least two points of different x; all are
/// positive.
double log_log_slope(std::span<const double> x, std::span<const double> y);

/// The sizes of the series.
struct ScaleSizes {
    std::vector<std::size_t> faces{62'500, 125'000, 250'000, 500'000};
    std::uint32_t side = 1024;  ///< texels a side of the textures of those meshes
    std::vector<std::uint32_t> sides{512, 1024, 2048, 4096};
    std::size_t mesh = 5'000;  ///< triangles of the mesh of those textures
};

/// The stages of a bake of bumpy spheres: connectivity, layout and solid points of the quad, patch
/// and chart atlases over triangles; then solid points, synthesis of marble, the write of its PNG
/// file, and all pictures of a material with MIP levels, over texels.
std::vector<ScaleSeries> bench_scale(const ScaleSizes& sizes);

}  // namespace burl
