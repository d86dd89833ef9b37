#include "atlas/gltf/choice.h"

#include <tiny_gltf.h>

#include <algorithm>

#include <fmt/format.h>

#include "atlas/base/error.h"
#include "atlas/base/glob.h"
#include "atlas/file/text_scanner.h"

namespace burl {
namespace {

using Globs = std::vector<std::string>;

bool matches_any(const std::string& name, const Globs& globs) {
    return globs.empty() || std::ranges::any_of(globs, [&](const std::string& glob) {
               return matches_glob(name, glob);
           });
}

/// Throws Error(usage) unless each of `globs`, given by --`kind`, matches one of `names`.
void check_globs(const Globs& globs, const std::vector<std::string>& names, const char* kind,
                 const std::string& path) {
    for (const std::string& glob : globs) {
        if (std::ranges::any_of(names, [&](const auto& name) { return matches_glob(name, glob); }))
            continue;
        std::vector<std::string> few;
        for (const std::string& name : names)
            if (few.size() < 8 && std::ranges::find(few, name) == few.end())
                few.push_back(printable(name, 40));
        throw Error(ExitCode::usage,
                    fmt::format("{}: no {} is called \"{}\"; there are: {}{}", path, kind,
                                printable(glob, 80), fmt::join(few, ", "),
                                few.size() < names.size() ? ", ..." : ""));
    }
}

bool has_primitive_without_material(const tinygltf::Model& model) {
    return std::ranges::any_of(model.meshes, [](const tinygltf::Mesh& mesh) {
        return std::ranges::any_of(mesh.primitives, [](const tinygltf::Primitive& primitive) {
            return primitive.material < 0;
        });
    });
}

template <class NameOf>
std::vector<std::string> all_names(std::size_t count, const NameOf& name_of) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < count; ++i) names.push_back(name_of(int(i)));
    return names;
}

std::string name_or_number(const std::string& name, const char* kind, int number) {
    return name.empty() ? fmt::format("{} {}", kind, number) : name;
}

/// The nodes that match, and all below them.
std::vector<bool> nodes_below(const tinygltf::Model& model, const Globs& globs) {
    std::vector<bool> chosen(model.nodes.size(), false);
    std::vector<int> open;
    for (int i = 0; i < int(model.nodes.size()); ++i)
        if (matches_any(gltf_node_name(model, i), globs)) open.push_back(i);
    while (!open.empty()) {
        const auto node = std::size_t(open.back());
        open.pop_back();
        if (chosen[node]) continue;
        chosen[node] = true;
        open.insert(open.end(), model.nodes[node].children.begin(),
                    model.nodes[node].children.end());
    }
    return chosen;
}

}  // namespace

std::string gltf_mesh_name(const tinygltf::Model& model, int mesh) {
    return name_or_number(model.meshes[std::size_t(mesh)].name, "mesh", mesh);
}

std::string gltf_node_name(const tinygltf::Model& model, int node) {
    return name_or_number(model.nodes[std::size_t(node)].name, "node", node);
}

std::string gltf_material_name(const tinygltf::Model& model, int material) {
    if (material < 0) return "no material";
    return name_or_number(model.materials[std::size_t(material)].name, "material", material);
}

ChosenGltf::ChosenGltf(const tinygltf::Model& model, const GltfChoice& choice,
                       const std::string& path)
    : model_(model), path_(path) {
    const auto mesh_name = [&](int i) { return gltf_mesh_name(model, i); };
    const auto node_name = [&](int i) { return gltf_node_name(model, i); };
    const int unnamed = has_primitive_without_material(model) ? 1 : 0;
    const auto material_name = [&](int i) { return gltf_material_name(model, i - unnamed); };
    check_globs(choice.meshes, all_names(model.meshes.size(), mesh_name), "mesh", path);
    check_globs(choice.nodes, all_names(model.nodes.size(), node_name), "node", path);
    check_globs(choice.materials,
                all_names(model.materials.size() + std::size_t(unnamed), material_name), "material",
                path);
    if (!choice.nodes.empty()) nodes_ = nodes_below(model, choice.nodes);
    for (int mesh = 0; mesh < int(model.meshes.size()); ++mesh) {
        const bool named = matches_any(gltf_mesh_name(model, mesh), choice.meshes);
        auto& chosen = primitives_.emplace_back();
        for (const tinygltf::Primitive& p : model.meshes[std::size_t(mesh)].primitives) {
            const std::array id{mesh, int(chosen.size())};
            chosen.push_back(named &&
                             (choice.only.empty() || std::ranges::binary_search(choice.only, id)) &&
                             matches_any(gltf_material_name(model, p.material), choice.materials));
        }
    }
}

bool ChosenGltf::has(int mesh, std::size_t primitive) const {
    return primitives_[std::size_t(mesh)][primitive];
}

std::vector<GltfPlacement> ChosenGltf::of(std::vector<GltfPlacement> placements) const {
    if (placements.empty()) return placements;
    for (GltfPlacement& placement : placements) {
        for (std::size_t i = placement.nodes.size(); i-- > 0 && !nodes_.empty();) {
            if (nodes_[std::size_t(placement.nodes[i])]) continue;
            placement.nodes.erase(placement.nodes.begin() + std::ptrdiff_t(i));
            placement.to_scene.erase(placement.to_scene.begin() + std::ptrdiff_t(i));
        }
    }
    std::erase_if(placements, [&](const GltfPlacement& placement) {
        const std::vector<bool>& chosen = primitives_[std::size_t(placement.mesh)];
        return placement.nodes.empty() || std::ranges::find(chosen, true) == chosen.end();
    });
    if (placements.empty())
        throw Error(ExitCode::usage,
                    fmt::format("{}: nothing in the scene is all that --mesh, --node and "
                                "--material name; choose other names",
                                path_));
    return placements;
}

}  // namespace burl
