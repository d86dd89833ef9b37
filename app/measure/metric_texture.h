#pragma once
// The textures that atlases are measured with: metric-marble or that of a recipe, on the mesh moved
// to the origin and scaled to a half diagonal of 1.
#include <string>

#include "app/recipe/recipe.h"
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

/// The mesh with its box's centre in the origin and a half diagonal of 1.
Mesh normalised(const Mesh& mesh);

/// A function that rounds a linear value to 8 bits of sRGB, as exports do, and decodes it again.
StoredValue in_8bit_srgb();

}  // namespace burl
