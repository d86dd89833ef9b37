#include "app/bake/groups.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "app/export/export.h"
#include "app/kept/scene.h"
#include "atlas/base/error.h"
#include "atlas/base/glob.h"
#include "atlas/read/gltf_origins.h"

namespace burl {
namespace {

/// An entry of --assign.
struct Assignment {
    std::string glob, recipe;
};

std::vector<Assignment> assignments_of(const BakeCommand& command) {
    std::vector<Assignment> result;
    for (const std::string& text : command.assigned) {
        const std::size_t at = text.find('=');
        result.push_back({text.substr(0, at), text.substr(at + 1)});
    }
    return result;
}

/// The primitives that share an atlas, by the number of their recipe: an index into the
/// assignments; -1: --recipe.
struct AtlasShares {
    std::string name;
    std::map<int, std::vector<std::array<int, 2>>> primitives{};
};

/// The recipe for a material; none where it stays as it is.
std::optional<int> recipe_for(const std::string& material, const std::vector<Assignment>& assigned,
                              bool others) {
    for (std::size_t i = 0; i < assigned.size(); ++i)
        if (matches_glob(material, assigned[i].glob)) return int(i);
    return others ? std::optional(-1) : std::nullopt;
}

/// Throws Error(usage) where an assignment is the first of no material that is carved.
void check_assignments(const BakeCommand& command, const std::vector<Assignment>& assigned,
                       const std::vector<GltfPrimitive>& primitives) {
    for (std::size_t i = 0; i < assigned.size(); ++i) {
        const Assignment& one = assigned[i];
        const auto is_its = [&](const GltfPrimitive& primitive) {
            return recipe_for(primitive.material_name, assigned, false) == int(i);
        };
        const auto has_its_name = [&](const GltfPrimitive& primitive) {
            return matches_glob(primitive.material_name, one.glob);
        };
        if (std::ranges::any_of(primitives, is_its)) continue;
        if (std::ranges::any_of(primitives, has_its_name))
            throw Error(ExitCode::usage,
                        fmt::format("{}: --assign {}={} does nothing: all materials of such a name "
                                    "have the recipe of an --assign before it; put it first",
                                    command.mesh, one.glob, one.recipe));
        std::set<std::string> names;
        for (const GltfPrimitive& primitive : primitives) names.insert(primitive.material_name);
        throw Error(ExitCode::usage,
                    fmt::format("{}: --assign {}={}: no material that is carved has such a name; "
                                "there are: {}",
                                command.mesh, one.glob, one.recipe, fmt::join(names, ", ")));
    }
}

/// The name of the atlas that a primitive with the recipe goes to: primitives of one atlas have the
/// same key and name.
std::pair<std::string, std::string> atlas_of(const BakeCommand& command,
                                             const std::vector<Assignment>& assigned,
                                             const GltfPrimitive& one, int recipe) {
    if (command.atlas_per == "mesh") return {std::to_string(one.mesh), one.mesh_name};
    if (command.atlas_per == "material") return {one.material_name, one.material_name};
    if (command.atlas_per == "scene") return {"", ""};
    return {std::to_string(recipe),
            recipe < 0 ? command.recipe.recipe : assigned[std::size_t(recipe)].recipe};
}

/// The atlases, in the order of their first primitives.
std::vector<AtlasShares> atlases_of(const BakeCommand& command,
                                    const std::vector<Assignment>& assigned) {
    const std::vector<GltfPrimitive> primitives = chosen_gltf_primitives(
        read_file(command.mesh, command.meshes.read.named), command.meshes.read);
    check_assignments(command, assigned, primitives);
    std::vector<AtlasShares> atlases;
    std::vector<std::string> keys;
    for (const GltfPrimitive& one : primitives) {
        const auto recipe =
            recipe_for(one.material_name, assigned, assigned.empty() || command.recipe_given);
        if (!recipe) continue;
        auto [key, name] = atlas_of(command, assigned, one, *recipe);
        const auto known = std::ranges::find(keys, key);
        const auto number = std::size_t(known - keys.begin());
        if (known == keys.end()) {
            keys.push_back(std::move(key));
            atlases.push_back({std::move(name)});
        }
        atlases[number].primitives[*recipe].push_back({one.mesh, one.primitive});
    }
    return atlases;
}

/// Whether an edit by --set is of the atlas, which all recipes share.
bool is_of_atlas(const std::string& setting) {
    return setting.starts_with("atlas.");
}

/// Throws Error(usage) where what only --recipe heeds is given and no material has its recipe.
void check_recipe_used(const BakeCommand& command, const std::vector<AtlasShares>& atlases) {
    const auto has_recipe = [](const AtlasShares& atlas) { return atlas.primitives.contains(-1); };
    if (std::ranges::any_of(atlases, has_recipe)) return;
    const std::vector<std::string>& settings = command.recipe.settings;
    const auto idle = std::ranges::find_if_not(settings, is_of_atlas);
    if (idle != settings.end())
        throw Error(ExitCode::usage,
                    fmt::format("--set {} changes the recipe of --recipe alone, and every material "
                                "that is carved has that of an --assign; write it into the "
                                "recipe's file",
                                *idle));
    if (command.recipe_given)
        throw Error(ExitCode::usage,
                    fmt::format("--recipe {} does nothing: every material has the recipe of an "
                                "--assign; leave it out",
                                command.recipe.recipe));
}

/// The recipe number `recipe` of the command: --set changes that of --recipe alone, but for the
/// atlas's numbers.
RecipeOptions recipe_options(const BakeCommand& command, const std::vector<Assignment>& assigned,
                             int recipe) {
    RecipeOptions options = command.recipe;
    if (recipe < 0) return options;
    options.recipe = assigned[std::size_t(recipe)].recipe;
    std::erase_if(options.settings, [](const std::string& one) { return !is_of_atlas(one); });
    return options;
}

/// The bake of an atlas.
BakeGroup group_of(const BakeCommand& command, const std::vector<Assignment>& assigned,
                   const AtlasShares& atlas) {
    BakeGroup group{command, command.out};
    group.command.assigned.clear();
    group.command.atlas_per = "scene";
    std::vector<std::array<int, 2>>& only = group.command.meshes.read.choice.only;
    only.clear();
    for (const auto& [recipe, primitives] : atlas.primitives) {
        group.shares.push_back({recipe_options(command, assigned, recipe), primitives});
        only.insert(only.end(), primitives.begin(), primitives.end());
    }
    std::ranges::sort(only);
    group.command.recipe = group.shares.front().recipe;
    if (group.shares.size() == 1) group.shares.clear();
    return group;
}

/// The name as a part of a file's: without folders and extension, in letters that need no care.
std::string in_file_name(const std::string& name) {
    std::string result = std::filesystem::path(name).stem().string();
    for (char& c : result)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
    return result.empty() ? "_" : result;
}

/// "a_wood.gltf" for the share "wood" of "a.gltf", with a number where that is taken.
std::string pictures_of(const std::string& out, const std::string& share,
                        std::set<std::string>& taken) {
    const std::filesystem::path path(out);
    const std::string stem = path.stem().string() + '_' + in_file_name(share);
    std::string name = stem;
    for (int number = 2; !taken.insert(name).second; ++number)
        name = fmt::format("{}_{}", stem, number);
    return (path.parent_path() / (name + path.extension().string())).string();
}

void check_options(const BakeCommand& command) {
    if (keeps_document(command.mesh, command.out) && command.pose.empty() && !command.displace &&
        !command.vertex_colors)
        return;
    const char* option = !command.assigned.empty()      ? "--assign"
                         : command.atlas_per != "scene" ? "--atlas-per"
                                                        : nullptr;
    if (option)
        throw Error(ExitCode::usage,
                    fmt::format("{}: {} is for a glTF that becomes a glTF, without --pose, "
                                "--displace and --vertex-colors; leave it out",
                                command.out, option));
}

}  // namespace

std::vector<BakeGroup> groups_of(const BakeCommand& command) {
    check_options(command);
    const std::vector<Assignment> assigned = assignments_of(command);
    if (assigned.empty() && command.atlas_per == "scene") return {{command, command.out}};
    const std::vector<AtlasShares> atlases = atlases_of(command, assigned);
    if (atlases.empty())
        throw Error(ExitCode::usage, fmt::format("{}: nothing is left to carve", command.mesh));
    if (!assigned.empty()) check_recipe_used(command, atlases);
    std::vector<BakeGroup> groups;
    std::set<std::string> taken;
    for (const AtlasShares& atlas : atlases) {
        groups.push_back(group_of(command, assigned, atlas));
        if (atlases.size() > 1)
            groups.back().pictures = pictures_of(command.out, atlas.name, taken);
    }
    return groups;
}

}  // namespace burl
