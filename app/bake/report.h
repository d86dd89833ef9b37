#pragma once
// What a bake has to say: the report of `burl bake --report` and its one line for people.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/bake/levels.h"
#include "app/export/export.h"
#include "app/measure/report.h"

namespace burl {

/// The recipe, the pipeline's mesh and atlas, which are the recipe's, and what its stages did,
/// after a bake of these MIP levels.
Json bake_json(const std::string& input, const std::vector<std::string>& outputs,
               const Recipe& recipe, Pipeline& pipeline, const AtlasMetrics& metrics,
               const LevelsAsked& levels, Json seconds);

/// How good the map of the pipeline's recipe is. (Measuring it takes a while.)
Json normals_json(Pipeline& pipeline, const NormalMap& map, double crease_degrees);

/// `paths`: of all frames, or the one that was named.
void print_summary(const Json& report, const std::vector<std::string>& paths);

}  // namespace burl
