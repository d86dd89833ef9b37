#pragma once
// The report of a bake: the JSON of `burl bake --report`, and its summary for people.
#include <string>
#include <vector>

#include "app/bake/bake.h"
#include "app/measure/report.h"

namespace burl {

/// The report of a bake as JSON: recipe, mesh, atlas, measures, MIP levels, `seconds`, the records
/// of the pipeline's stages, and the results of compression. The pipeline's atlas must be the
/// recipe's, and the atlas measured.
Json bake_json(const std::string& input, const std::vector<std::string>& outputs,
               const Recipe& recipe, Pipeline& pipeline, const BakeResult& result, Json seconds);

/// The report of a bake of vertex colours, which has no atlas.
Json vertex_colors_json(const std::string& input, const std::vector<std::string>& outputs,
                        const Recipe& recipe, Pipeline& pipeline, const BakeResult& result,
                        Json seconds);

/// The errors of the normal map of the pipeline's recipe, as JSON, in degrees. Measured at about
/// 20,000 points, which takes a while.
Json normals_json(Pipeline& pipeline, const NormalMap& map, double crease_degrees);

/// Prints the summary of a report, and a line on compression; a report marked as up to date has one
/// line that says so. `paths` are the textures of all frames.
void print_summary(const Json& report, const std::vector<std::string>& paths);

}  // namespace burl
