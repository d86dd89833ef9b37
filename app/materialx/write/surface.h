#pragma once
// Documents of MaterialX 1.38 for a baked material: a standard_surface whose inputs are numbers,
// and images where a channel has a picture.
#include <string>
#include <utility>
#include <vector>

#include "app/recipe/material.h"

namespace burl::materialx {

/// A baked material; files are named as seen from the document.
struct BakedSurface {
    std::string name;         ///< any text
    Material material{};      ///< numbers; those of channels with a picture are factors of it
    std::string color{};      ///< the picture of the base colour, in sRGB
    bool has_alpha = false;   ///< whether that picture has alpha, which is the opacity
    double alpha_cutoff = 0;  ///< the alpha from which a texel is there; 0: alpha is a share
    std::string normals{};    ///< the normal map; empty: none
    bool tangent_space = true;
    /// One picture per channel that varies, by the channel's name (procedural/graph/channel.h).
    std::vector<std::pair<std::string, std::string>> pictures{};
    bool closest = false;  ///< whether lookups take the nearest texel
};

/// A document, and what its surface does not show, as a sentence; empty: nothing.
struct SurfaceDocument {
    std::string text, lost;
};

/// The document. It has a material and a surface of the name, and a node graph whose outputs are
/// called like the channels.
SurfaceDocument surface_document(const BakedSurface& surface);

}  // namespace burl::materialx
