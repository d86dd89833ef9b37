#include "app/bake/report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/base/messages.h"
#include "app/measure/normal_error.h"

namespace burl {

Json bake_json(const std::string& input, const std::vector<std::string>& outputs,
               const Recipe& recipe, Pipeline& pipeline, const AtlasMetrics& metrics,
               const LevelsAsked& levels, Json seconds) {
    Json atlas = metrics_json(pipeline.atlas(), metrics);
    if (const PatchAtlas* patches = pipeline.mesh_atlas().patches())
        atlas["patch"] = patches_json(*patches);
    return {{"input", input},
            {"outputs", outputs},
            {"recipe", Json::parse(to_json(recipe))},
            {"mesh", mesh_json(pipeline.mesh(), pipeline.connectivity())},
            {"atlas", std::move(atlas)},
            {"capacity", capacity_json(capacity(pipeline.mesh().triangles.size(), recipe.atlas))},
            {"mip_levels", levels.count},
            {"level_rule", levels.count == 0 ? Json() : Json(to_string(levels.rule))},
            {"seconds", std::move(seconds)},
            {"stages", stages_json(pipeline.records())},
            {"versions", versions_json()}};
}

Json normals_json(Pipeline& pipeline, const NormalMap& map, double crease_degrees) {
    const NormalErrors errors = normal_errors(pipeline, ViewerFrames::of(pipeline, crease_degrees),
                                              components(map), map.tangent_space, 20000);
    return {{"space", map.tangent_space ? "tangent" : "object"},
            {"mean_tilt_degrees", errors.mean_tilt},
            {"error_degrees",
             {{"mean", errors.mean},
              {"percentile99", errors.percentile99},
              {"largest", errors.largest}}}};
}

void print_summary(const Json& report, const std::vector<std::string>& paths) {
    const Json& atlas = report["atlas"];
    std::string name = paths.front();
    if (paths.size() > 1) name += " to " + paths.back();
    print_line(fmt::format(
        "{}: {} triangles, {} atlas {} x {}, coverage {:.1f} %, relative scale {:.2f}, {:.2f} s",
        name, report["mesh"]["triangles"].get<std::uint64_t>(), atlas["kind"].get<std::string>(),
        atlas["size"].get<int>(), atlas["size"].get<int>(), 100.0 * atlas["coverage"].get<double>(),
        atlas["relative_scale"].get<double>(), report["seconds"]["total"].get<double>()));
}

}  // namespace burl
