#pragma once
// `burl bake --normals`: the recipe's bumps as a normal map, which space it is in and where it
// goes.
#include <optional>
#include <string>

#include "app/export/export.h"
#include "app/pipeline/pipeline.h"

namespace burl {

enum class NormalSpace { none, tangent, object };

/// `text` is none, tangent or object; empty: tangent if the recipe has bumps. Throws Error(usage)
/// for normals of a recipe without bumps, and for those of the object in a glTF.
NormalSpace normals_asked(const std::string& text, const Recipe& recipe,
                          const std::string& out_path);

/// 16 bits where `depth` is 16, else 8; nothing for NormalSpace::none.
std::optional<NormalMap> bake_normals(Pipeline& pipeline, NormalSpace space, int depth,
                                      double crease_degrees);

}  // namespace burl
