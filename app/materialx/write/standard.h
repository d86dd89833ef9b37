#pragma once
// A material of glTF's channels as Autodesk's standard_surface in a MaterialX document.
#include <string>
#include <vector>

#include "app/materialx/write/xml.h"
#include "app/recipe/material.h"

namespace burl::materialx {

/// A material whose varying channels are outputs of a node graph.
struct StandardSurface {
    std::string name;     ///< an element_name()
    Material material{};  ///< numbers of channels without an output, and factors of the emission
    /// Outputs of the graph NG_name: base_color, always; opacity (a color3), normal, height, and
    /// channels by their names (procedural/graph/channel.h).
    std::vector<std::string> outputs{};
};

/// Adds the surface SR_name and the material `name` to a document, and, for a height, the
/// displacement DS_name.
void add_standard_surface(XmlElement& document, const StandardSurface& surface);

/// A sentence about the part of a material that standard_surface does not show, the occlusion;
/// empty where there is none.
std::string lost_in_surface(const StandardSurface& surface);

}  // namespace burl::materialx
