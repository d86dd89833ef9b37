#pragma once
// The textures that atlases are measured with: metric-marble or that of a recipe, on the mesh moved
// to the origin and scaled to a half diagonal of 1; and the errors of MIP levels against the mean
// over the surface (atlas/measure/surface_truth.h).
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/pipeline/pipeline.h"
#include "atlas/measure/lookup_errors.h"

namespace burl {

/// A texture on a normalised mesh.
struct MetricTexture {
    std::string name;
    SolidColor color;     ///< linear light at points of normalised(mesh)
    double detail = 0.0;  ///< about the size of its finest detail there (surface_mean.h)
};

inline constexpr const char* metric_marble_name = "metric-marble";

MetricTexture metric_marble_texture();

/// The recipe's texture, placed on `mesh` by the recipe's scale and space. Its detail is 0.4 of the
/// shortest lattice cell of its noise, as for metric-marble, and at most 1/40; for graphs, whose
/// nodes may be anything, 1/200.
MetricTexture recipe_texture(const Recipe& recipe, const Mesh& mesh);

/// Number of pixels in each row of sampled views that are measured.
inline constexpr std::size_t view_points = 2000;

/// The mesh with its box's centre in the origin and a half diagonal of 1.
Mesh normalised(const Mesh& mesh);

/// A function that rounds a linear value to 8 bits of sRGB, as exports do, and decodes it again.
StoredValue in_8bit_srgb();

/// The true means for levels `first` to `last` of the pipeline's texture, at about `points` points
/// of its atlas's mesh; without points for level 0 and for grazing views.
SurfaceTruth level_truth(Pipeline& pipeline, std::uint32_t first, std::uint32_t last,
                         std::size_t points);

/// RMS errors of bilinear lookups within each of `levels`, however computed; the first is level 1,
/// as far as the truth has levels; 0 for levels without means.
std::vector<double> level_errors(const Atlas& atlas, std::span<const Image<RgbF>> levels,
                                 const SurfaceTruth& truth);

}  // namespace burl
