#pragma once
// The texture that atlases are judged with: metric-marble, or that of a recipe, seen on the mesh
// moved to the origin and scaled to a half diagonal of 1.
#include <string>

#include "app/recipe/recipe.h"
#include "atlas/measure/lookup_errors.h"

namespace burl {

struct MetricTexture {
    std::string name;
    SolidColor color;     ///< linear, at points of normalised(mesh)
    double detail = 0.0;  ///< about the size of its finest detail there (surface_mean.h)
};

inline constexpr const char* metric_marble_name = "metric-marble";

MetricTexture metric_marble_texture();

/// The recipe's texture where its own scale and space put it on `mesh`. Detail is 0.4 of the
/// shortest lattice cell of its noise, as it is for metric-marble, and at most 1/40; of a graph,
/// whose nodes may be anything, 1/200.
MetricTexture recipe_texture(const Recipe& recipe, const Mesh& mesh);

/// The mesh with the box's middle in the origin and its half diagonal 1.
Mesh normalised(const Mesh& mesh);

/// A linear value in [0, 1] after rounding it to 8 bits sRGB, as exported.
StoredValue in_8bit_srgb();

}  // namespace burl
