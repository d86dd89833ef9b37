// The record of a bake: what its outputs are made from, and whether they are up to date.
#include <algorithm>
#include <iterator>

#include "app/bake/job.h"
#include "app/bake/up_to_date.h"
#include "app/base/sha256.h"
#include "app/base/version.h"
#include "app/export/command_files.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/json.h"

namespace burl {

/// Whether the output may name files that the mesh's own names: a .gltf that is kept, or an .obj
/// that is carved in part.
bool BakeJob::names_files_of_mesh() const {
    const bool keeps = is_gltf(command_.out)
                           ? kept_document()
                           : !plan_.displaces && command_.meshes.read.choice.any();
    return keeps && keeps_file_names(command_.mesh, command_.out);
}

Json BakeJob::what_it_is_made_from(const Json& settings) const {
    // A document that is kept keeps its other images, too.
    const MeshFiles which = kept_document() ? MeshFiles::named : MeshFiles::read;
    std::vector<std::string> files =
        files_of_mesh(command_.mesh, which, command_.meshes.read.named);
    if (is_pose_file(command_.pose))
        std::ranges::move(files_of_mesh(command_.pose, MeshFiles::read, command_.meshes.read.named),
                          std::back_inserter(files));
    std::ranges::move(images_of_recipe(command_.recipe.recipe, recipe()),
                      std::back_inserter(files));
    for (std::size_t i = 1; i < shares_.size(); ++i)
        std::ranges::move(images_of_recipe(shares_[i].recipe.recipe, sharing_[i]),
                          std::back_inserter(files));
    Json made_from = {{"burl", burl_version()},
                      {"inputs", content_of(files, command_.recipe.images->digests())},
                      {"recipe", Json::parse(to_json(recipe()))},
                      {"options", settings}};
    if (files.empty() || files[0] != command_.mesh) made_from["sample"] = command_.mesh;
    if (names_files_of_mesh()) made_from["place"] = place_of(command_.mesh, command_.out);
    for (const Recipe& recipe : sharing_)
        made_from["recipes"].push_back(Json::parse(to_json(recipe)));
    for (const BakeJob& other : others_) {
        made_from["recipes"].push_back(other.made_from_["recipe"]);
        for (const Json& input : other.made_from_["inputs"]) made_from["inputs"].push_back(input);
    }
    if (recipes_->size() > 1) {
        Sha256 hash;
        for (const Recipe& recipe : *recipes_) hash.add(to_json(recipe));
        made_from["frames"] = hash.digest();
    }
    return made_from;
}

std::optional<Json> BakeJob::known_report() const {
    if (command_.force || !command_.economy.skips().allows(Skip::up_to_date)) return std::nullopt;
    std::optional<Json> report = report_if_up_to_date(command_.out, made_from_);
    if (!report) return report;
    // The folder may have been moved, or may be named from another working directory.
    (*report)["input"] = command_.mesh;
    if (!command_.udim)
        (*report)["outputs"] = outputs(plan_.paths, report->at("mip_levels").get<std::uint32_t>());
    // Normals are measured only if a report is wanted, so the record may lack them.
    if (has_normals() && wants_report() && !report->contains("normals")) return std::nullopt;
    (*report)["up_to_date"] = true;
    return report;
}

}  // namespace burl
