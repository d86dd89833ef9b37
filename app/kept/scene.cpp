#include "app/kept/scene.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "app/export/export.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"
#include "atlas/gltf/container.h"

namespace burl {
namespace {

std::size_t count_of(const Json& document, const char* list) {
    return document.contains(list) ? document[list].size() : 0;
}

/// Number of objects of the document that have extras.
std::size_t count_extras(const Json& value) {
    if (!value.is_structured()) return 0;
    std::size_t count = value.is_object() && value.contains("extras") ? 1 : 0;
    for (const auto& item : value.items())
        if (!value.is_object() || item.key() != "extras") count += count_extras(item.value());
    return count;
}

/// Names of vertex attributes that are no positions and normals, and whether there are targets.
struct Attributes {
    std::set<std::string> names{};
    bool targets = false;
};

Attributes attributes_of(const Json& document) {
    Attributes result;
    if (!document.contains("meshes")) return result;
    for (const Json& mesh : document["meshes"])
        for (const Json& primitive : mesh["primitives"]) {
            result.targets |= primitive.contains("targets");
            for (const auto& item : primitive["attributes"].items())
                if (item.key() != "POSITION" && item.key() != "NORMAL" && item.key() != "TANGENT")
                    result.names.insert(item.key());
        }
    return result;
}

void add_counts(const Json& document, std::vector<std::string>& losses) {
    using Pair = std::pair<const char*, const char*>;
    constexpr std::array lists{Pair{"skins", "skins"}, Pair{"animations", "animations"},
                               Pair{"cameras", "cameras"}, Pair{"materials", "materials"},
                               Pair{"textures", "textures"}};
    for (const auto& [list, name] : lists)
        if (const std::size_t count = count_of(document, list); count > 0)
            losses.push_back(fmt::format("{} {}", count, name));
    if (count_of(document, "scenes") > 1)
        losses.push_back(fmt::format("{} further scenes", count_of(document, "scenes") - 1));
    if (document.contains("nodes") && std::ranges::any_of(document["nodes"], [](const Json& node) {
            return node.contains("children");
        }))
        losses.emplace_back("the hierarchy of nodes");
    if (const std::size_t count = count_extras(document); count > 0)
        losses.push_back(fmt::format("extras of {} objects", count));
}

/// Whether the node is a skinned mesh alone, which its joints move and no node above it.
bool is_skinned_leaf(const Json& node) {
    return node.contains("skin") && !node.contains("children");
}

/// Puts the roots of all scenes under a new node each, with the transform.
void add_root(Json& document, const Mat4d& frame) {
    if (!document.contains("scenes")) return;
    for (Json& scene : document["scenes"]) {
        if (!scene.contains("nodes") || scene["nodes"].empty()) continue;
        Json node{{"name", "axes and units"}, {"matrix", Json::array()}};
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) node["matrix"].push_back(frame[c][r]);
        Json roots = Json::array();
        for (const Json& root : scene["nodes"])
            (is_skinned_leaf(document["nodes"][root.get<std::size_t>()]) ? roots : node["children"])
                .push_back(root);
        if (!node.contains("children")) continue;
        document["nodes"].push_back(std::move(node));
        roots.push_back(document["nodes"].size() - 1);
        scene["nodes"] = std::move(roots);
    }
}

}  // namespace

bool keeps_document(const std::string& mesh_path, const std::string& out_path) {
    return !is_sample_mesh(mesh_path) && has_gltf_extension(mesh_path) && holds_mesh(out_path) &&
           is_gltf(out_path);
}

bool keeps_lines(const std::string& mesh_path, const std::string& out_path) {
    return is_obj(out_path) && (is_sample_mesh(mesh_path) || lower_extension(mesh_path) == ".obj");
}

std::shared_ptr<KeptScene> kept_scene(const std::string& mesh_path, NamedFiles named) {
    return with_types_of_gltf(
        mesh_path, [&] { return std::make_shared<KeptScene>(read_file(mesh_path, named)); });
}

void prepare(KeptScene& scene, const std::string& mesh_path, const ReadOptions& options,
             const std::string& pictures, const Mat4d& frame) {
    scene.origins = read_gltf_origins(read_file(mesh_path, options.named), options);
    scene.frame = frame;
    for (GltfPartOrigin& part : scene.origins.parts) part.to_scene = frame * part.to_scene;
    scene.pictures = lower_extension(pictures) == ".glb" ? "" : pictures;
}

namespace {

std::vector<AtomicFile> files_of(KeptScene& scene, const SceneContent& content,
                                 std::span<const CornerOrigin> corners) {
    KeptDocument& document = scene.document;
    std::ranges::move(carve(document, {scene.origins, corners, content, scene.uv_set,
                                       scene.pictures, scene.labels}),
                      std::back_inserter(scene.pending));
    if (!scene.is_last) return {};
    if (scene.frame != Mat4d(1.0)) add_root(document.json, scene.frame);
    std::vector<AtomicFile> files = write_kept(document, content.path);
    if (scene.is_strict && !document.losses.empty())
        throw Error(ExitCode::unsupported, fmt::format("{}: --strict: {}", content.path,
                                                       losses_sentence(document.losses)));
    std::ranges::move(files, std::back_inserter(scene.pending));
    return std::move(scene.pending);
}

std::vector<std::string> losses_of_document(const std::string& mesh_path) {
    std::vector<std::string> losses;
    const FileBuffer file = read_file(mesh_path);
    const Json document = Json::parse(split_gltf(file).json);
    add_counts(document, losses);
    const Attributes attributes = attributes_of(document);
    if (attributes.targets) losses.emplace_back("morph targets");
    if (!attributes.names.empty())
        losses.push_back(fmt::format("the attributes {}", fmt::join(attributes.names, ", ")));
    if (count_of(document, "extensionsUsed") > 0) {
        std::vector<std::string> names = document["extensionsUsed"];
        losses.push_back(fmt::format("the extensions {}", fmt::join(names, ", ")));
    }
    return losses;
}

/// Losses of a mesh whose file is no glTF. One material or group divides nothing, and gives way to
/// what is carved.
std::vector<std::string> losses_of_plain(const Mesh& mesh, const std::string& out_path,
                                         bool keeps_uvs) {
    std::vector<std::string> losses;
    const auto add = [&](std::uint64_t count, const char* several) {
        if (count > 1) losses.push_back(fmt::format("{} {}", count, several));
    };
    add(mesh.notes.materials, "materials");
    add(mesh.notes.groups, "groups");
    if (!is_gltf(out_path) && !is_obj(out_path)) add(mesh.parts.size(), "objects");
    if (mesh.notes.ignored_elements > 0) losses.emplace_back("elements other than faces");
    if (!mesh.corners.uvs.empty() && !keeps_uvs) losses.emplace_back("texture coordinates");
    if (!mesh.corners.colors.empty()) losses.emplace_back("colours of points");
    return losses;
}

}  // namespace

std::vector<AtomicFile> kept_files(KeptScene& scene, const SceneContent& content,
                                   std::span<const CornerOrigin> corners) {
    return with_types_of_gltf(scene.document.path(),
                              [&] { return files_of(scene, content, corners); });
}

std::vector<std::string> losses_of_flat(const std::string& mesh_path, const Mesh& mesh,
                                        const std::string& out_path, bool keeps_uvs) {
    std::vector<std::string> losses;
    if (const auto count = mesh.notes.unchosen_triangles; count > 0)
        losses.push_back(fmt::format("{} triangles that are not chosen", count));
    if (is_sample_mesh(mesh_path)) return losses;
    std::ranges::move(
        has_gltf_extension(mesh_path)
            ? with_types_of_gltf(mesh_path, [&] { return losses_of_document(mesh_path); })
            : losses_of_plain(mesh, out_path, keeps_uvs),
        std::back_inserter(losses));
    return losses;
}

std::string losses_sentence(const std::vector<std::string>& losses) {
    return fmt::format("not kept: {}", fmt::join(losses, "; "));
}

}  // namespace burl
