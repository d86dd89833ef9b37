#pragma once
// Surface shaders as the channels of a recipe's material.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/materialx/reader.h"

namespace burl::materialx {

/// The part of a surface that a recipe has.
struct Surface {
    NodeRef base_color = 0;
    /// Channels by the recipe's names, but for `ior` and `emissive_strength`.
    std::vector<std::pair<std::string, NodeRef>> channels{};
    double ior = 1.5, emissive_strength = 1.0;
    std::optional<NodeRef> height{};  ///< rise of the surface, in the mesh's units
};

/// Reads a surface shader; `displacement` is null where the material has none. What the recipe has
/// no channel for is noted as lost.
Surface read_surface(Reader& reader, const Target& shader, const Target& displacement);

}  // namespace burl::materialx
