// The part of a bake that goes back into the mesh's own document: its files, its further atlases,
// and what it loses.
#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "app/bake/job.h"
#include "app/bake/vertex_colors.h"
#include "app/base/stopwatch.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {

std::vector<std::string> BakeJob::paths_of(const std::string& out, std::uint32_t levels) const {
    return output_paths(out, levels, has_normals(),
                        picture_names(recipes_of_atlas(), plan_.material()),
                        plan_.material().rough_levels(), plan_.coding.format);
}

std::size_t BakeJob::pictures() const {
    return 1 + picture_names(recipes_of_atlas(), plan_.material()).size() + (has_normals() ? 1 : 0);
}

/// The files of a document with several atlases: those of the document, then each atlas's pictures.
std::vector<std::string> BakeJob::document_outputs(std::uint32_t levels) const {
    const bool has_buffer = paths_of(command_.out, 0).size() > 1;  // .gltf, whose second is .bin
    const std::ptrdiff_t own = has_buffer ? 2 : 1;
    std::vector<std::string> outputs = paths_of(command_.out, 0);
    outputs.resize(std::size_t(own));
    const auto add_pictures = [&](const BakeJob& job) {
        const std::vector<std::string> paths = job.paths_of(job.pictures_, levels);
        outputs.insert(outputs.end(), paths.begin() + own, paths.end());
    };
    add_pictures(*this);
    std::ranges::for_each(others_, add_pictures);
    return outputs;
}

/// Whether the mesh goes back into the document that it was read from.
bool BakeJob::kept_document() const {
    return command_.pose.empty() && !plan_.displaces && !plan_.vertex_colors &&
           keeps_document(command_.mesh, command_.out);
}

/// The document that the bake goes back to; null where the output is a scene of its own.
std::shared_ptr<KeptScene> BakeJob::kept_scene() const {
    if (!kept_document()) return nullptr;
    std::shared_ptr<KeptScene> kept = burl::kept_scene(command_.mesh, command_.meshes.read.named);
    kept->uv_set = command_.uv_set;
    kept->is_strict = command_.strict;
    return kept;
}

/// Bakes the document's further atlases; the files of all are committed with the last.
void BakeJob::bake_others(const std::shared_ptr<KeptScene>& kept, BakeResult& result,
                          Json& reports) const {
    for (const BakeJob& other : others_) {
        const auto start = std::chrono::steady_clock::now();
        Pipeline pipeline(other.command_.load_mesh());
        const double reading = seconds_since(start);
        kept->is_last = &other == &others_.back();
        const auto synthesizer = other.synthesizer();
        const BakeResult one = other.bake_into(pipeline, synthesizer, kept, LaterBake::none);
        Json seconds = {{"read", reading}, {"total", seconds_since(start)}};
        reports.push_back(other.report_of(pipeline, pipeline.recipe(), one, synthesizer.get(),
                                          std::move(seconds)));
        result.committed.insert(result.committed.end(), one.committed.begin(), one.committed.end());
        result.lost = one.lost;
    }
}

/// Everything that the recipes' documents say and the recipes do not hold.
std::vector<std::string> BakeJob::recipe_losses() const {
    std::vector<std::string> losses = command_.recipe_losses();
    for (std::size_t i = 1; i < shares_.size(); ++i)
        std::ranges::move(command_of(shares_[i]).recipe_losses(), std::back_inserter(losses));
    return losses;
}

/// Says what of the mesh's file the output does not hold; with --strict, before the bake.
std::vector<std::string> BakeJob::losses_before(const Mesh& mesh) const {
    if (!holds_mesh(command_.out) || kept_document()) return {};
    const bool keeps_uvs = recipe().atlas.kind == AtlasKind::uv && holds_colors(command_.out);
    std::vector<std::string> losses;
    if (!keeps_lines(command_.mesh, command_.out) || plan_.displaces)
        losses = losses_of_flat(command_.mesh, mesh, command_.out, keeps_uvs);
    if (!holds_colors(command_.out)) losses.emplace_back(stl_loss);
    if (plan_.vertex_colors)
        std::ranges::move(lost_with_vertex_colors(recipe(), command_.out),
                          std::back_inserter(losses));
    if (!losses.empty() && command_.strict)
        throw Error(ExitCode::unsupported,
                    fmt::format("{}: --strict: {}", command_.out, losses_sentence(losses)));
    return losses;
}

/// The recipe's keys of the pose's weight.
KeyTrack BakeJob::pose_keys() const {
    for (const KeyTrack& track : command_.recipe.load_keyed().animation.tracks)
        if (track.path == "pose.weight") return track;
    return {};
}

}  // namespace burl
