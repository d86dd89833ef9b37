#pragma once
// A recipe's texture at points, in float64: for checks and for renderers of one's own.
#include <span>
#include <string>
#include <vector>

#include "app/library/mesh.h"
#include "app/library/recipe.h"

namespace burl::library {

/// The options of evaluate().
struct EvaluateOptions {
    /// Channel of the material: "base_color", "alpha", "height", "roughness", "metallic",
    /// "emissive" and the like; empty: the texture's colour.
    std::string channel{};
    /// The mesh whose shape masks of the texture are of, each at the mesh's point nearest to the
    /// one asked for; null: none. Needed only by textures that read masks.
    const Mesh* mesh = nullptr;
    /// Is told how many points are done, as the share; empty: nobody is.
    Progress progress{};
};

/// The texture at n points.
struct Evaluated {
    /// The value f of the texture, shape (n); of a colour its luminance (ITU-R BT.709).
    std::vector<double> values;
    /// The derivatives of the values by x, y and z of the point, shape (n, 3).
    std::vector<double> gradients;
    /// Red, green and blue in linear light, shape (n, 3); three times the number where the channel
    /// is one.
    std::vector<double> colors;
};

/// Evaluates the recipe at points in solid space, before the recipe's scale: shape (n, 3). Filters,
/// bumps' heights, paint and the atlas have no effect. Throws Error: usage where the number of
/// coordinates is not a multiple of 3, for coordinates that are not finite and for an unknown
/// channel; stopped where the callback says so; unsupported for points too far from the origin, and
/// for a texture that reads a mask where there is no mesh.
BURL_API Evaluated evaluate(const Recipe& recipe, std::span<const double> points,
                            const EvaluateOptions& options = {});

}  // namespace burl::library
