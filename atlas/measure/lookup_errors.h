#pragma once
// The errors that a viewer sees: lookups of a texture against the colours that the surface shows
// there. Errors of colours are root mean squares over the channels.
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "atlas/base/mip_chain.h"
#include "atlas/measure/charts.h"
#include "atlas/measure/lookup.h"
#include "atlas/measure/surface_points.h"
#include "atlas/measure/surface_truth.h"
#include "atlas/measure/texture_values.h"

namespace burl {

/// Bleeding: the shares, 0 to 1, of lookups' weight on texels outside the point's own chart.
struct ForeignShare {
    double foreign = 0.0;      ///< share on texels of another chart or of none
    double other_chart = 0.0;  ///< share on texels that hold another chart's value
};

/// Mean shares over the points for plain bilinear lookups in level `level`, whose texels are means
/// of 4^level texels (for sizes that are no power of two, of the texels they touch). `charts` holds
/// each triangle's chart.
ForeignShare foreign_share(const Atlas& atlas, const TextureValues& texture,
                           std::span<const std::uint32_t> charts,
                           std::span<const SurfacePoint> points, std::uint32_t level);

/// Errors of anisotropic lookups with footprints eight times as long as wide
/// (atlas/measure/lookup.h).
struct GrazingError {
    double rmse = 0.0, rmse_8bit = 0.0, truth_noise = 0.0;
};

/// Errors of plain bilinear lookups in one level.
struct LevelError {
    std::uint32_t level = 0;
    double rmse = 0.0, rmse_8bit = 0.0;  ///< level 0: at all points; others: at the level points
    double truth_noise = 0.0;            ///< RMS error of the truth itself
    /// RMS difference of the two sides along all edges between triangles, weighted by length; 0
    /// where the texture goes on across an edge.
    double mismatch = 0.0;
    /// Mean shares of lookup weight: `foreign` on texels of another chart or of none, `other_chart`
    /// on texels that hold another chart's value (a texel of no chart holds the nearest one's).
    double foreign = 0.0, other_chart = 0.0;
    std::optional<GrazingError> grazing;  ///< set for levels with a grazing truth
};

/// A sampler of sampled views (atlas/measure/lookup.h).
struct ViewSampler {
    std::string_view name;
    int most = 1;          ///< TEXTURE_MAX_ANISOTROPY
    bool ellipse = false;  ///< whether it takes the pixel's ellipse for its steps
    /// The value that it gives.
    Vec3d lookup(const MipChain<Vec3f>& chain, const Vec2d& at, const TexelSteps& steps) const {
        return sampler_lookup(chain, at, ellipse ? ellipse_steps(steps) : steps, most);
    }
};

inline constexpr std::array<ViewSampler, 6> view_samplers{
    {{"trilinear", 1}, {"2x", 2}, {"4x", 4}, {"8x", 8}, {"16x", 16}, {"16x ellipse", 16, true}}};

/// Errors of a row of sampled views, by sampler.
struct ViewError {
    double minification = 1.0, tilt = 0.0;  ///< atlas/measure/sampled_views.h; degrees
    std::array<double, view_samplers.size()> rmse{};
    double truth_noise = 0.0;  ///< RMS error of the truth itself
};

/// Errors of all lookups of one texture.
struct LookupErrors {
    double psnr = 0.0, psnr_8bit = 0.0;  ///< PSNR of level 0, dB, peak 1; infinite if exact
    double seam_rmse = 0.0;              ///< level 0 at points within one texel of a chart's border
    double interior_rmse = 0.0;          ///< level 0 at all other points
    bool sharp = false;                  ///< whether the levels were sharpened
    double seam_points = 0.0;            ///< share of points within one texel of a chart's border
    std::vector<LevelError> levels;      ///< errors by level, from level 0
    std::vector<ViewError> views{};      ///< errors of the truth's sampled views, row by row
};

/// Root mean square error of plain bilinear lookups in a level of the atlas's texture, at points
/// where they should give `values`.
double lookup_rmse(const Atlas& atlas, const Image<Vec3f>& level,
                   std::span<const SurfacePoint> points, std::span<const Vec3d> values);

/// The errors of the truth's views; `chain` has the texture's levels.
std::vector<ViewError> view_errors(const Mesh& mesh, const Atlas& atlas,
                                   const MipChain<Vec3f>& chain, const SampledViews& views);

/// A linear value in [0, 1] after storing it and reading it back.
using StoredValue = std::function<double(double)>;

/// Measures the errors of a texture. `truth` must be of the same mesh, the same f as `texture` and
/// the same texture size. Each level is the box mean of the level before; for the figures in 8 bits
/// every level is stored by `in_8bit` before the next is made of it. Where `sharp`, levels are
/// sharpened once all are made (atlas/base/sharp_level.h), and stored again.
LookupErrors measure_lookups(const Mesh& mesh, const Atlas& atlas, const TextureValues& texture,
                             std::span<const MeshEdge> edges, const SurfaceTruth& truth,
                             const StoredValue& in_8bit, bool sharp = false);

}  // namespace burl
