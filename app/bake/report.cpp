#include "app/bake/report.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/base/messages.h"
#include "app/measure/normal_error.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

/// The results of compression: blocks and places, texels and bytes before and after, and the
/// largest error.
Json compress_json(const BakedAtlas& baked) {
    const CompressNotes& notes = *baked.compressed;
    const std::uint64_t bytes = std::visit(
        [](const auto& image) { return std::uint64_t{sizeof(image(0, 0))}; }, baked.image);
    const Vec2d extent = baked.packed->extent();
    return {{"width", std::uint64_t(extent.x)},
            {"height", std::uint64_t(extent.y)},
            {"blocks", notes.blocks},
            {"places", notes.places},
            {"texels_before", notes.texels_before},
            {"texels_after", notes.texels_after},
            {"bytes_before", bytes * notes.texels_before},
            {"bytes_after", bytes * notes.texels_after},
            {"largest_error", notes.largest_error}};
}

void print_compressed(const Json& compressed) {
    const auto number = [&](const char* key) { return compressed[key].get<std::uint64_t>(); };
    fmt::print(
        "compressed to {} x {}: {} of {} blocks kept, {:.1f} % of the texels and bytes saved, "
        "largest error {:.4f}\n",
        number("width"), number("height"), number("places"), number("blocks"),
        100.0 * (1.0 - double(number("texels_after")) / double(number("texels_before"))),
        compressed["largest_error"].get<double>());
}

/// The counts of triangle strips.
Json strips_json(const StripCounts& counts) {
    const double triangles = double(std::max<std::uint64_t>(counts.triangles, 1));
    return {{"strips", counts.strips},
            {"triangles", counts.triangles},
            {"triangles_left_out", counts.left_out},
            {"indices", counts.indices},
            {"indices_per_triangle", double(counts.indices) / triangles},
            {"border_loops", counts.border_loops}};
}

}  // namespace

Json bake_json(const std::string& input, const std::vector<std::string>& outputs,
               const Recipe& recipe, Pipeline& pipeline, const BakeResult& result, Json seconds) {
    const LevelsAsked& levels = result.levels;
    Json atlas = metrics_json(pipeline.atlas(), *result.metrics);
    if (const PatchAtlas* patches = pipeline.mesh_atlas().patches())
        atlas["patch"] = patches_json(*patches);
    Json report{
        {"input", input},
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
    if (result.texture.compressed) report["compressed"] = compress_json(result.texture);
    if (result.strips.strips > 0) report["strips"] = strips_json(result.strips);
    return report;
}

Json vertex_colors_json(const std::string& input, const std::vector<std::string>& outputs,
                        const Recipe& recipe, Pipeline& pipeline, const BakeResult& result,
                        Json seconds) {
    Json report{{"input", input},
                {"outputs", outputs},
                {"recipe", Json::parse(to_json(recipe))},
                {"mesh", mesh_json(pipeline.mesh(), pipeline.connectivity())},
                {"vertex_colors", pipeline.mesh().positions.size()},
                {"mip_levels", 0},
                {"seconds", std::move(seconds)},
                {"versions", versions_json()}};
    if (result.strips.strips > 0) report["strips"] = strips_json(result.strips);
    return report;
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
    const std::string all =
        paths.size() > 1 ? paths.front() + " to " + paths.back() : paths.front();
    if (report.contains("up_to_date")) return print_line(fmt::format("{}: up to date", all));
    if (report.contains("vertex_colors"))
        return print_line(fmt::format("{}: {} triangles, colours of {} points, {:.2f} s",
                                      paths.front(),
                                      report["mesh"]["triangles"].get<std::uint64_t>(),
                                      report["vertex_colors"].get<std::uint64_t>(),
                                      report["seconds"]["total"].get<double>()));
    const Json& atlas = report["atlas"];
    const std::size_t others = report.contains("others") ? report["others"].size() : 0;
    print_line(fmt::format(
        "{}: {} triangles, {} atlas {} x {}, coverage {:.1f} %, relative scale {:.2f}, {:.2f} s{}",
        all, report["mesh"]["triangles"].get<std::uint64_t>(), atlas["kind"].get<std::string>(),
        atlas["width"].get<int>(), atlas["height"].get<int>(),
        100.0 * atlas["coverage"].get<double>(), atlas["relative_scale"].get<double>(),
        report["seconds"]["total"].get<double>(),
        others > 0 ? fmt::format("; the first of {} atlases", others + 1) : ""));
    if (report.contains("compressed")) print_compressed(report["compressed"]);
}

}  // namespace burl
