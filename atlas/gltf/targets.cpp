#include "atlas/gltf/targets.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <unordered_set>

#include <fmt/format.h>

namespace burl {

std::size_t target_count(const tinygltf::Mesh& mesh) {
    std::size_t count = 0;
    for (const tinygltf::Primitive& primitive : mesh.primitives)
        count = std::max(count, primitive.targets.size());
    return count;
}

std::vector<std::string> target_names(const tinygltf::Mesh& mesh) {
    const std::size_t count = target_count(mesh);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < count; ++i) names.push_back(fmt::format("{}", i));
    if (!mesh.extras.IsObject() || !mesh.extras.Has("targetNames")) return names;
    const tinygltf::Value& given = mesh.extras.Get("targetNames");
    if (!given.IsArray()) return names;
    for (std::size_t i = 0; i < std::min(count, given.ArrayLen()); ++i)
        if (const tinygltf::Value& name = given.Get(int(i));
            name.IsString() && !name.Get<std::string>().empty())
            names[i] = name.Get<std::string>();
    return names;
}

std::vector<std::string> target_names(const tinygltf::Model& model) {
    std::vector<std::string> names;
    std::unordered_set<std::string> known;
    for (const tinygltf::Mesh& mesh : model.meshes)
        for (std::string& name : target_names(mesh))
            if (known.insert(name).second) names.push_back(std::move(name));
    return names;
}

std::optional<std::size_t> find_target(const tinygltf::Mesh& mesh, const std::string& name) {
    const std::vector<std::string> names = target_names(mesh);
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) return {};
    return std::size_t(found - names.begin());
}

}  // namespace burl
