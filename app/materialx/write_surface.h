#pragma once
// Documents of MaterialX 1.38 for a baked material: a standard_surface whose inputs are numbers,
// and images where a channel has a picture.
#include <string>
#include <utility>
#include <vector>

#include "app/materialx/write_xml.h"
#include "app/recipe/material.h"
#include "atlas/base/image.h"

namespace burl::materialx {

/// A baked material; files are named as seen from the document.
struct BakedSurface {
    std::string name;         ///< any text
    Material material{};      ///< numbers, which are factors of the pictures
    std::string color{};      ///< the picture of the base colour, in sRGB
    bool has_alpha = false;   ///< whether that picture has alpha, which is the opacity
    double alpha_cutoff = 0;  ///< the alpha from which a texel is there; 0: alpha is a share
    std::string normals{};    ///< the normal map; empty: none
    bool tangent_space = true;
    /// One picture per channel that varies, by the channel's name (procedural/graph/channel.h).
    std::vector<std::pair<std::string, std::string>> pictures{};
    bool closest = false;  ///< whether lookups take the nearest texel
};

/// The document. It has a material and a surface of the name, and a node graph whose outputs are
/// called like the channels.
std::string surface_document(const BakedSurface& surface);

/// What the surface does not show, as a sentence: the occlusion, of which standard_surface has no
/// input, so that it is an output of the graph and no more. Empty where nothing is.
std::string lost_in_document(const BakedSurface& surface);

}  // namespace burl::materialx
