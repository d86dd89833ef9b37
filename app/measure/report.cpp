#include "app/measure/report.h"

#include <array>
#include <cstdio>

#include <fmt/format.h>

#include "app/base/atomic_file.h"
#include "app/base/version.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

/// Calls visit(name, record) for the stages that were asked for.
template <class Visit>
void for_each_stage(const StageRecords& records, const Visit& visit) {
    for (std::size_t k = 0; k < stage_names.size(); ++k) {
        const StageRecord& record = records[Stage(k)];
        if (record.runs + record.stopped > 0) visit(std::string(stage_names[k]), record);
    }
}

/// Work done and skipped, by reason; `spared` counts the work of whole stages whose results were
/// reused.
Json counts_json(std::uint64_t done, std::uint64_t spared,
                 const std::array<std::uint64_t, skip_names.size()>& skipped = {}) {
    Json reasons = Json::object();
    std::uint64_t total = 0;
    for (std::size_t k = 0; k < skip_names.size(); ++k) {
        const std::uint64_t count = skipped[k] + (Skip(k) == Skip::stages ? spared : 0);
        if (count > 0) reasons[std::string(skip_names[k])] = count;
        total += count;
    }
    return {{"done", done}, {"skipped", total}, {"skipped_by", std::move(reasons)}};
}

Json stage_json(const StageRecord& record) {
    const StageCost &done = record.done, &spared = record.spared;
    Json json = {{"runs", record.runs}, {"kept", record.kept}};
    if (record.stopped > 0) json["stopped"] = record.stopped;
    json["seconds"] = record.seconds;
    if (done.triangles > 0) json["triangles"] = counts_json(done.triangles, spared.triangles);
    const SynthesisWork& work = done.work;
    if (work.texels > 0)
        json["texels"] = counts_json(work.texels, spared.work.texels, work.texels_skipped);
    Json octaves = counts_json(work.octaves, spared.work.octaves, work.octaves_skipped);
    if (work.octaves > 0 || octaves["skipped"] > 0) json["octaves"] = std::move(octaves);
    json["bytes"] = counts_json(done.bytes, spared.bytes);
    return json;
}

}  // namespace

Json mesh_json(const Mesh& mesh, const Connectivity& connectivity) {
    const MeshNotes& notes = mesh.notes;
    return {{"name", mesh.name},
            {"triangles", mesh.triangles.size()},
            {"points", mesh.positions.size()},
            {"parts", mesh.parts.size()},
            {"shells", connectivity.shells},
            {"interior_edges", connectivity.interior_edges},
            {"boundary_edges", connectivity.boundary_edges},
            {"split_faces", connectivity.split_faces},
            {"polygons", notes.polygons},
            {"degenerate_triangles", notes.degenerate_triangles},
            {"duplicate_triangles", notes.duplicate_triangles},
            {"merged_points", notes.merged_points},
            {"unreferenced_points", notes.unreferenced_points},
            {"ignored_elements", notes.ignored_elements},
            {"notes", notes.sentences}};
}

Json metrics_json(const Atlas& atlas, const AtlasMetrics& metrics) {
    const LayoutNotes& notes = atlas.notes;
    return {{"kind", to_string(atlas.options.kind)},
            {"overscan", to_string(atlas.options.overscan)},
            {"weight", to_string(atlas.options.weight)},
            {"partition", to_string(atlas.options.partition)},
            {"gutter", atlas.options.gutter},
            {"diagonals", to_string(atlas.options.diagonals)},
            {"size", atlas.options.size},
            {"width", atlas.options.columns()},
            {"height", atlas.options.rows()},
            {"triangles", metrics.triangles},
            {"zero_area", metrics.zero_area},
            {"charts", metrics.charts},
            {"area", metrics.area},
            {"coverage", metrics.coverage},
            {"texel_coverage", metrics.texel_coverage},
            {"relative_scale", metrics.relative_scale},
            {"density_5_50_95", metrics.density},
            {"overscan_texels", notes.overscan_texels},
            {"saved_texels", notes.saved_texels},
            {"paired_triangles", notes.paired_triangles},
            {"strips", notes.strips},
            {"minimal_cells", notes.minimal_cells},
            {"unread_texels", notes.unread_texels},
            {"gutter_texels", notes.gutter_texels},
            {"narrowed_gutters", notes.narrowed_gutters},
            {"shared_texels", notes.shared_texels},
            {"shared_triangles", notes.shared_triangles},
            {"overlapped_texels", notes.overlapped_texels},
            {"overlapping_triangles", notes.overlapping_triangles},
            {"flat_triangles", notes.flat_triangles},
            {"fallback", notes.fallback}};
}

Json capacity_json(const Capacity& capacity) {
    return {{"texels_per_triangle", capacity.texels_per_triangle},
            {"suffices", capacity.suffices()},
            {"vertex_colours_better", capacity.vertex_colours_better()},
            {"size_for_25", capacity.good_size},
            {"size_for_5", capacity.least_size},
            {"holding_size", capacity.holding_size}};
}

Json patches_json(const PatchAtlas& atlas) {
    const PatchMapNotes& notes = atlas.notes;
    return {{"patches", atlas.patches.size()},
            {"planar", notes.planar_patches},
            {"gutter", atlas.layout.gutter},
            {"predicted_stretch", atlas.layout.predicted_stretch},
            {"partitions_tried", atlas.candidates},
            {"extra_points", atlas.refined.extra_points.size()},
            {"tubes_slit", notes.tubes_slit},
            {"socks_slit", notes.socks_slit},
            {"holes_closed", notes.holes_closed},
            {"regions_halved", notes.regions_halved},
            {"unmapped_triangles", atlas.unmapped}};
}

Json times_json(const StageRecords& records) {
    Json json = Json::object();
    for_each_stage(records, [&](const std::string& name, const StageRecord& record) {
        json[name] = record.seconds;
    });
    return json;
}

Json stages_json(const StageRecords& records) {
    Json json = Json::object();
    for_each_stage(records, [&](const std::string& name, const StageRecord& record) {
        json[name] = stage_json(record);
    });
    return json;
}

Json versions_json() {
    Json json = {{"burl", burl_version()}};
    for (const auto& [name, version] : component_versions()) json[name] = version;
    return json;
}

void write_json(const std::string& path, const Json& json) {
    const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    if (path == "-") {
        fmt::print("{}", text);
        return;
    }
    write_file(path, text);
}

}  // namespace burl
