// Walks a glTF's nodes (specification 3.5) with a stack of its own, as files may nest without
// limit.
#include "atlas/gltf/scene.h"

#include <tiny_gltf.h>

#include <map>

#include "atlas/gltf/motion.h"

namespace burl {
namespace {

std::vector<int> nodes_without_parent(const tinygltf::Model& model) {
    std::vector<bool> is_child(model.nodes.size(), false);
    for (const tinygltf::Node& node : model.nodes)
        for (const int child : node.children) is_child[static_cast<std::size_t>(child)] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i)
        if (!is_child[i]) roots.push_back(static_cast<int>(i));
    return roots;
}

std::vector<int> root_nodes(const tinygltf::Model& model) {
    if (!model.scenes.empty())
        return model.scenes[static_cast<std::size_t>(std::max(model.defaultScene, 0))].nodes;
    return nodes_without_parent(model);
}

}  // namespace

std::vector<Mat4d> scene_transforms(const tinygltf::Model& model, std::span<const Mat4d> local) {
    std::vector<Mat4d> to_scene(local.begin(), local.end());
    std::vector<int> open = nodes_without_parent(model);
    while (!open.empty()) {
        const auto node = static_cast<std::size_t>(open.back());
        open.pop_back();
        for (const int child : model.nodes[node].children) {
            const auto c = static_cast<std::size_t>(child);
            to_scene[c] = to_scene[node] * local[c];
            open.push_back(child);
        }
    }
    return to_scene;
}

std::vector<GltfPlacement> scene_placements(const tinygltf::Model& model,
                                            std::span<const Mat4d> to_scene) {
    std::vector<GltfPlacement> placements;
    std::map<std::pair<int, bool>, std::size_t> placement_of;
    std::vector<bool> visited(model.nodes.size(), false);
    std::vector<int> open;
    const auto push = [&](const std::vector<int>& nodes) {
        open.insert(open.end(), nodes.rbegin(), nodes.rend());
    };
    push(root_nodes(model));
    while (!open.empty()) {
        const int number = open.back();
        open.pop_back();
        const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(number)];
        if (visited[static_cast<std::size_t>(number)]) continue;  // a scene may name it twice
        visited[static_cast<std::size_t>(number)] = true;
        push(node.children);
        if (node.mesh < 0) continue;
        const bool skinned = node.skin >= 0;
        const auto [entry, is_new] =
            placement_of.try_emplace({node.mesh, skinned}, placements.size());
        if (is_new) placements.push_back({node.mesh, node.skin, {}, {}});
        if (!is_new && skinned) continue;
        GltfPlacement& placement = placements[entry->second];
        placement.nodes.push_back(number);
        placement.to_scene.push_back(skinned ? Mat4d(1.0)
                                             : to_scene[static_cast<std::size_t>(number)]);
    }
    return placements;
}

std::vector<GltfPlacement> scene_placements(const tinygltf::Model& model) {
    return scene_placements(model, scene_transforms(model, nodes_at_rest(model).local));
}

}  // namespace burl
