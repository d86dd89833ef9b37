#pragma once
// `burl bake --normals`: the recipe's bumps as a normal map, and the space of its normals.
#include <optional>
#include <string>

#include "app/export/export.h"
#include "app/pipeline/pipeline.h"

namespace burl {

/// Space of a normal map's normals; none: no normal map.
enum class NormalSpace { none, tangent, object };

/// Parses --normals: none, tangent or object; empty means tangent if the recipe has bumps, else
/// none. Throws Error(usage) if normals are asked for and the recipe has no bumps, and for object
/// space in a glTF.
NormalSpace normals_asked(const std::string& text, const Recipe& recipe,
                          const std::string& out_path);

/// The normal map of the pipeline's recipe, of 16 bits per channel if `depth` is 16, else 8; none
/// for NormalSpace::none.
std::optional<NormalMap> bake_normals(Pipeline& pipeline, NormalSpace space, int depth,
                                      double crease_degrees);

}  // namespace burl
