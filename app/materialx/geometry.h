#pragma once
// What a material reads of the surface.
#include <optional>
#include <string_view>

#include "app/materialx/reader.h"

namespace burl::materialx {

/// A geometric property by MaterialX's name: positions and normals, in whichever space, and the
/// first set of texture coordinates. None for others.
std::optional<Value> geometric_property(Reader& reader, std::string_view property);

/// The texture coordinates (u, v, 0), v upwards, of the mesh's own file.
NodeRef texture_coordinates(NodeBuilder& nodes);

}  // namespace burl::materialx
