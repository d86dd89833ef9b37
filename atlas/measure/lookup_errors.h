#pragma once
// The errors a viewer sees: lookups of a texture against what the surface shows there. Errors of
// colours are root mean squares over the channels.
#include <functional>
#include <optional>
#include <vector>

#include "atlas/base/mip_chain.h"
#include "atlas/measure/charts.h"
#include "atlas/measure/surface_truth.h"
#include "atlas/measure/texture_values.h"

namespace burl {

/// Anisotropic lookups of footprints eight times as long as wide (atlas/measure/anisotropic.h).
struct GrazingError {
    double rmse = 0.0, rmse_8bit = 0.0, truth_noise = 0.0;
};

/// Plain bilinear lookups in one level.
struct LevelError {
    std::uint32_t level = 0;
    double rmse = 0.0, rmse_8bit = 0.0;  ///< level 0: at all points; others: at the level points
    double truth_noise = 0.0;            ///< RMS error of the truth itself
    /// RMS difference of the two sides along edges between triangles, by length; where the texture
    /// goes on across an edge there is none.
    double mismatch = 0.0;
    /// Mean share of lookup weight on texels of another chart or of none; on texels that hold
    /// another chart's value (a texel of no chart holds that of the nearest one).
    double foreign = 0.0, other_chart = 0.0;
    std::optional<GrazingError> grazing;  ///< of the levels that the truth has it for
};

struct LookupErrors {
    double psnr = 0.0, psnr_8bit = 0.0;  ///< level 0, dB, peak 1; infinite without any error
    double seam_rmse = 0.0;              ///< level 0, points within one texel of a chart's edge
    double interior_rmse = 0.0;          ///< level 0, all others
    double seam_points = 0.0;            ///< share of points near an edge
    std::vector<LevelError> levels;      ///< from level 0
};

/// Of plain bilinear lookups in any level of the atlas's texture, where they should give `values`.
double lookup_rmse(const Atlas& atlas, const Image<Vec3f>& level,
                   std::span<const SurfacePoint> points, std::span<const Vec3d> values);

/// What is left of a linear value after storing it; both are in [0, 1].
using StoredValue = std::function<double(double)>;

/// `truth` of the same mesh, the same f as in `texture` and a size as large. Each level is the box
/// mean of the one before, for the figures in 8 bits as `in_8bit` stored it.
LookupErrors measure_lookups(const Mesh& mesh, const Atlas& atlas, const TextureValues& texture,
                             std::span<const MeshEdge> edges, const SurfaceTruth& truth,
                             const StoredValue& in_8bit);

}  // namespace burl
