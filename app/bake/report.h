#pragma once
// The report of a bake: the JSON of `burl bake --report`, and its summary in one line.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/bake/levels.h"
#include "app/export/export.h"
#include "app/measure/report.h"

namespace burl {

/// The report of a bake as JSON: recipe, mesh, atlas, measures, MIP levels, `seconds`, and the
/// records of the pipeline's stages. The pipeline's atlas must be the recipe's.
Json bake_json(const std::string& input, const std::vector<std::string>& outputs,
               const Recipe& recipe, Pipeline& pipeline, const AtlasMetrics& metrics,
               const LevelsAsked& levels, Json seconds);

/// The errors of the normal map of the pipeline's recipe, as JSON, in degrees. Measured at about
/// 20,000 points, which takes a while.
Json normals_json(Pipeline& pipeline, const NormalMap& map, double crease_degrees);

/// Prints the summary of a report; `paths` are the textures of all frames.
void print_summary(const Json& report, const std::vector<std::string>& paths);

}  // namespace burl
