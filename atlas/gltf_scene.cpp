// Walks a glTF's nodes (specification 3.5) with a stack of its own, as files may nest without
// limit.
#include "atlas/gltf_scene.h"

#include <tiny_gltf.h>

#include <map>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace burl {
namespace {

Mat4d from_matrix(const std::vector<double>& columns) {
    Mat4d matrix(1.0);
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 3; ++r)  // the last row of an affine matrix is 0 0 0 1
            matrix[c][r] = columns[static_cast<std::size_t>(4 * c + r)];
    return matrix;
}

Mat4d local_transform(const tinygltf::Node& node) {
    if (node.matrix.size() == 16) return from_matrix(node.matrix);
    Mat4d matrix(1.0);
    if (node.translation.size() == 3)
        matrix = glm::translate(
            matrix, Vec3d(node.translation[0], node.translation[1], node.translation[2]));
    if (node.rotation.size() == 4) {
        const glm::dquat q(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
        if (glm::length(q) > 0.0) matrix *= glm::mat4_cast(glm::normalize(q));
    }
    if (node.scale.size() == 3)
        matrix = glm::scale(matrix, Vec3d(node.scale[0], node.scale[1], node.scale[2]));
    return matrix;
}

std::vector<int> root_nodes(const tinygltf::Model& model) {
    if (!model.scenes.empty())
        return model.scenes[static_cast<std::size_t>(std::max(model.defaultScene, 0))].nodes;
    std::vector<bool> is_child(model.nodes.size(), false);
    for (const tinygltf::Node& node : model.nodes)
        for (const int child : node.children) is_child[static_cast<std::size_t>(child)] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i)
        if (!is_child[i]) roots.push_back(static_cast<int>(i));
    return roots;
}

struct Visit {
    int node;
    Mat4d parent_to_scene;
};

}  // namespace

std::vector<GltfPlacement> scene_placements(const tinygltf::Model& model) {
    std::vector<GltfPlacement> placements;
    std::map<std::pair<int, bool>, std::size_t> placement_of;
    std::vector<bool> visited(model.nodes.size(), false);
    std::vector<Visit> open;
    const auto push = [&](const std::vector<int>& nodes, const Mat4d& to_scene) {
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
            open.push_back({*node, to_scene});
    };
    push(root_nodes(model), Mat4d(1.0));
    while (!open.empty()) {
        const Visit visit = open.back();
        open.pop_back();
        const auto number = static_cast<std::size_t>(visit.node);
        if (visited[number]) continue;  // a scene may name a node and its ancestor
        visited[number] = true;
        const tinygltf::Node& node = model.nodes[number];
        const Mat4d to_scene = visit.parent_to_scene * local_transform(node);
        push(node.children, to_scene);
        if (node.mesh < 0) continue;
        const bool skinned = node.skin >= 0;
        const auto [entry, is_new] =
            placement_of.try_emplace({node.mesh, skinned}, placements.size());
        if (is_new) placements.push_back({node.mesh, skinned, {}});
        if (is_new || !skinned)
            placements[entry->second].to_scene.push_back(skinned ? Mat4d(1.0) : to_scene);
    }
    return placements;
}

}  // namespace burl
