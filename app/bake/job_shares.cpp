// Recipes that share the atlas of a bake's document: their loading, checks, labels and report.
#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "app/bake/job.h"
#include "app/bake/shared_pictures.h"
#include "app/base/messages.h"
#include "app/options/metres.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/lattice_check.h"
#include "atlas/base/error.h"

namespace burl {

BakeCommand BakeJob::command_of(const BakeShare& share) const {
    BakeCommand command = command_;
    command.recipe = share.recipe;
    return command;
}

/// The recipes of the shares, in the first one's atlas; empty where there is one recipe.
std::vector<Recipe> BakeJob::load_shares() const {
    std::vector<Recipe> recipes;
    for (const BakeShare& share : shares_) {
        const bool is_first = recipes.empty();  // which is the command's
        Recipe& one =
            recipes.emplace_back(is_first ? recipe() : frames_of(command_of(share))->front());
        if (one.atlas != recipe().atlas)
            warn(
                fmt::format("{}: {} asks for another atlas than {}, whose it shares; "
                            "--atlas-per recipe gives it one of its own",
                            command_.out, one.name, recipe().name));
        one.atlas = recipe().atlas;
    }
    return recipes;
}

std::span<const Recipe> BakeJob::recipes_of_atlas() const {
    return sharing_.empty() ? std::span(recipes_->data(), 1) : sharing_;
}

/// Throws Error(usage) where the command asks for what several atlases, or recipes that share one,
/// cannot have.
void BakeJob::check_shares() const {
    const char* const single = !command_.emitted_glsl.empty() ? "--emit-glsl"
                               : !command_.solid_map.empty()  ? "--solid-map"
                               : !command_.channels.empty()   ? "--channels"
                                                              : nullptr;
    if (single && (!sharing_.empty() || !others_.empty()))
        throw Error(ExitCode::usage,
                    fmt::format("{0}: {1} is for one atlas with one recipe, and this bake has {2}; "
                                "choose what has one with --mesh, --node or --material, or leave "
                                "{1} out",
                                command_.out, single,
                                others_.empty() ? fmt::format("{} recipes", sharing_.size())
                                                : fmt::format("{} atlases", 1 + others_.size())));
    for (const Recipe& recipe : sharing_)
        if (const std::string option = not_of(recipe); !option.empty())
            throw Error(
                ExitCode::usage,
                fmt::format("{}: {} is not done for an atlas that {} and {} share; add "
                            "--atlas-per recipe, or leave {} out",
                            command_.out, option, sharing_[0].name, sharing_[1].name, option));
    if (sharing_.empty()) return;
    if (plan_.levels.count > 0) check_shared_levels(sharing_, command_.out);
}

/// The recipes of the pipeline's labels in the mesh's metres; the labels are those of the scene.
std::vector<Recipe> BakeJob::shared_recipes(const Mesh& mesh) const {
    std::vector<Recipe> recipes = sharing_;
    for (std::size_t i = 0; i < recipes.size(); ++i) {
        set_metres({&recipes[i], 1}, shares_[i].recipe, command_.meshes.frame, mesh);
        check_lattice(recipes[i], mesh);
    }
    return recipes;
}

/// Per triangle of the mesh the number of its recipe; empty where there is one.
std::vector<std::uint32_t> BakeJob::labels_of(const GltfOrigins& origins) const {
    std::vector<std::uint32_t> labels;
    if (shares_.empty()) return labels;
    for (const GltfRun& run : origins.runs) {
        const std::array id{origins.parts[run.part].mesh, run.primitive};
        const auto has_run = [&](const BakeShare& share) {
            return std::ranges::find(share.primitives, id) != share.primitives.end();
        };
        const auto share = std::ranges::find_if(shares_, has_run);
        labels.insert(labels.end(), run.triangle_count, std::uint32_t(share - shares_.begin()));
    }
    return labels;
}

}  // namespace burl
