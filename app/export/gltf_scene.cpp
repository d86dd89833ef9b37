// View, accessor and mesh ids are indices into the JSON arrays.
#include "app/export/gltf_scene.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "app/export/gltf_material.h"
#include "app/export/vertices.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {
namespace {

using Json = nlohmann::ordered_json;

enum Gl {  // OpenGL's constants in glTF documents
    gl_unsigned_short = 5123,
    gl_unsigned_int = 5125,
    gl_float = 5126,
    gl_nearest = 9728,
    gl_linear = 9729,
    gl_linear_mipmap_linear = 9987,
    gl_clamp_to_edge = 33071,
    gl_array_buffer = 34962,
    gl_element_array_buffer = 34963,
    gl_triangle_strip = 5,
};

/// The largest 16-bit index; 65535 itself is reserved (primitive restart).
constexpr std::size_t max_short_index = 65534;

template <class T>
std::span<const std::uint8_t> as_bytes(const std::vector<T>& values) {
    return {reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)};
}

std::size_t append(Json& array, Json value) {
    array.push_back(std::move(value));
    return array.size() - 1;
}

/// Appends an accessor with a bufferView of its own at the end of the buffer; returns its index.
std::size_t add_accessor(GltfScene& scene, std::span<const std::uint8_t> bytes,
                         std::optional<Gl> target, Gl component, std::size_t count,
                         const char* type) {
    const std::size_t view =
        append(scene.json["bufferViews"],
               {{"buffer", 0}, {"byteOffset", scene.binary_size}, {"byteLength", bytes.size()}});
    if (target) scene.json["bufferViews"][view]["target"] = int(*target);
    scene.binary.push_back(bytes);
    scene.binary_size += bytes.size() + padding_after(bytes.size()).size();
    return append(scene.json["accessors"], {{"bufferView", view},
                                            {"componentType", int(component)},
                                            {"count", count},
                                            {"type", type}});
}

/// Whether all components are finite: conversion to float32 has not overflowed.
bool all_finite(const std::vector<Vec3f>& values) {
    return std::ranges::all_of(values, [](const Vec3f& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    });
}

std::size_t add_positions(GltfScene& scene, const std::vector<Vec3f>& positions) {
    const std::size_t accessor = add_accessor(scene, as_bytes(positions), gl_array_buffer, gl_float,
                                              positions.size(), "VEC3");
    Vec3f low = positions.front(), high = low;
    for (const Vec3f& p : positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    Json& json = scene.json["accessors"][accessor];
    json["min"] = {low.x, low.y, low.z};
    json["max"] = {high.x, high.y, high.z};
    return accessor;
}

std::size_t add_indices(GltfScene& scene, const std::vector<std::uint32_t>& indices,
                        std::size_t vertex_count) {
    if (vertex_count > max_short_index + 1) {
        return add_accessor(scene, as_bytes(indices), gl_element_array_buffer, gl_unsigned_int,
                            indices.size(), "SCALAR");
    }
    const auto& narrow = scene.narrow_indices.emplace_back(indices.begin(), indices.end());
    return add_accessor(scene, as_bytes(narrow), gl_element_array_buffer, gl_unsigned_short,
                        narrow.size(), "SCALAR");
}

/// The accessors of one part's arrays.
struct PrimitiveIds {
    std::size_t position = 0, normal = 0, indices = 0;
    std::optional<std::size_t> uv{}, color{}, block{}, tangent{};
    bool is_strip = false;
    Json target{};  ///< the morph target's accessors; null: none
};

std::size_t add_mesh(GltfScene& scene, const std::string& name, const PrimitiveIds& ids,
                     const std::optional<ExportPose>& pose) {
    Json attributes{{"POSITION", ids.position}, {"NORMAL", ids.normal}};
    if (ids.uv) attributes["TEXCOORD_0"] = *ids.uv;
    if (ids.color) attributes["COLOR_0"] = *ids.color;
    if (ids.tangent) attributes["TANGENT"] = *ids.tangent;
    if (ids.block) attributes["_BURL_BLOCK"] = *ids.block;
    Json primitive{{"attributes", attributes}, {"indices", ids.indices}, {"material", 0}};
    if (ids.is_strip) primitive["mode"] = int(gl_triangle_strip);
    if (!ids.target.is_null()) primitive["targets"] = Json::array({ids.target});
    Json mesh{{"name", name}, {"primitives", Json::array({primitive})}};
    if (!ids.target.is_null()) {
        mesh["weights"] = Json::array({pose->weight});
        mesh["extras"]["targetNames"] = Json::array({pose->corners.name});
    }
    return append(scene.json["meshes"], std::move(mesh));
}

/// Makes names unique: "leg", "leg 2", "leg 3".
class UniqueNames {
  public:
    std::string operator()(const std::string& wanted) {
        std::string name = wanted;
        std::size_t& last = last_.try_emplace(wanted, 1).first->second;
        while (!used_.insert(name).second) name = fmt::format("{} {}", wanted, ++last);
        return name;
    }

  private:
    std::unordered_set<std::string> used_;
    /// The last number tried; lower ones are taken.
    std::unordered_map<std::string, std::size_t> last_;
};

/// Appends a node. Translations and scales beyond float32 are written as they are, since JSON holds
/// doubles: Burl and other readers in double precision keep them, and the rest cannot show a mesh
/// of that size at all.
void add_node(GltfScene& scene, const std::string& name, std::size_t mesh,
              const NodeTransform& place) {
    Json node{{"name", name}, {"mesh", mesh}};
    if (place.translation != Vec3d(0.0)) {
        node["translation"] = {place.translation.x, place.translation.y, place.translation.z};
    }
    if (place.rotation != NodeTransform().rotation) node["rotation"] = place.rotation;
    if (place.scale != Vec3d(1.0)) node["scale"] = {place.scale.x, place.scale.y, place.scale.z};
    scene.json["scenes"][0]["nodes"].push_back(append(scene.json["nodes"], std::move(node)));
}

Json add_target(GltfScene& scene, const VertexTarget& target) {
    const auto add = [&](const std::vector<Vec3f>& values) {
        return add_accessor(scene, as_bytes(values), gl_array_buffer, gl_float, values.size(),
                            "VEC3");
    };
    Json ids{{"POSITION", add_positions(scene, target.positions)}, {"NORMAL", add(target.normals)}};
    if (!target.tangents.empty()) ids["TANGENT"] = add(target.tangents);
    return ids;
}

/// Adds an animation of the pose's weight, with a channel per node. A smooth track is a cubic one
/// with tangents of 0.
void add_animation(GltfScene& scene, const KeyTrack& track) {
    const bool cubic = track.ease == KeyEase::smooth;
    std::vector<float>&times = scene.key_times, &values = scene.key_values;
    for (const KeyPoint& key : track.keys) {
        times.push_back(float(key.seconds));
        if (cubic) values.push_back(0.0f);
        values.push_back(float(key.value));
        if (cubic) values.push_back(0.0f);
    }
    const auto add = [&](const std::vector<float>& numbers) {
        return add_accessor(scene, as_bytes(numbers), std::nullopt, gl_float, numbers.size(),
                            "SCALAR");
    };
    const std::size_t input = add(times), output = add(values);
    scene.json["accessors"][input]["min"] = {times.front()};
    scene.json["accessors"][input]["max"] = {times.back()};
    Json animation{
        {"name", "pose"},
        {"channels", Json::array()},
        {"samplers", Json::array({{{"input", input},
                                   {"output", output},
                                   {"interpolation", cubic ? "CUBICSPLINE" : "LINEAR"}}})}};
    for (std::size_t node = 0; node < scene.json["nodes"].size(); ++node)
        animation["channels"].push_back(
            {{"sampler", 0}, {"target", {{"node", node}, {"path", "weights"}}}});
    scene.json["animations"] = Json::array({std::move(animation)});
}

PrimitiveIds add_primitive(GltfScene& scene, const PartVertices& v, StripCounts* strips) {
    PrimitiveIds ids;
    ids.is_strip = strips != nullptr;
    ids.position = add_positions(scene, v.positions);
    ids.normal = add_accessor(scene, as_bytes(v.normals), gl_array_buffer, gl_float,
                              v.normals.size(), "VEC3");
    if (!v.uvs.empty())
        ids.uv =
            add_accessor(scene, as_bytes(v.uvs), gl_array_buffer, gl_float, v.uvs.size(), "VEC2");
    if (!v.colors.empty())
        ids.color = add_accessor(scene, as_bytes(v.colors), gl_array_buffer, gl_float,
                                 v.colors.size(), "VEC4");
    const std::vector<std::uint32_t>& indices =
        strips ? scene.strips.emplace_back(strip_indices(v.indices, *strips)) : v.indices;
    ids.indices = add_indices(scene, indices, v.positions.size());
    if (!v.tangents.empty())
        ids.tangent = add_accessor(scene, as_bytes(v.tangents), gl_array_buffer, gl_float,
                                   v.tangents.size(), "VEC4");
    if (!v.blocks.empty())
        ids.block = add_accessor(scene, as_bytes(v.blocks), gl_array_buffer, gl_float,
                                 v.blocks.size(), "VEC4");
    if (!v.target.positions.empty()) ids.target = add_target(scene, v.target);
    return ids;
}

/// Throws Error(unsupported) where a position is beyond the range of 32-bit floats.
void check_range(const SceneContent& content, const PartVertices& vertices) {
    const auto refuse = [&](const std::string& what) {
        throw Error(ExitCode::unsupported,
                    fmt::format("{}: {} farther than the 32-bit floats of a glTF reach; write an "
                                ".obj instead",
                                content.path, what));
    };
    if (!all_finite(vertices.positions))
        refuse(fmt::format("a placement of \"{}\" takes points",
                           content.mesh.parts[vertices.part].name));
    if (!all_finite(vertices.target.positions))
        refuse(fmt::format("the pose \"{}\" moves points", content.options.pose->corners.name));
}

void add_part(GltfScene& scene, const SceneContent& content, const PartVertices& vertices,
              UniqueNames& names) {
    const Part& part = content.mesh.parts[vertices.part];
    const std::optional<ExportPose>& pose = content.options.pose;
    const std::string fallback_name = content.mesh.name.empty() ? "mesh" : content.mesh.name;
    const std::string name = part.name.empty() ? fallback_name : part.name;
    check_range(content, vertices);
    const PrimitiveIds ids = add_primitive(scene, vertices, content.options.strips);
    const std::size_t mesh = add_mesh(scene, name, ids, pose);
    for (const Mat4d& instance : part.instances) {
        if (const auto place = decompose(centred(instance, vertices))) {
            add_node(scene, names(name), mesh, *place);
            continue;
        }
        const PartVertices& moved = scene.placed.emplace_back(placed(vertices, instance));
        check_range(content, moved);
        const PrimitiveIds moved_ids = add_primitive(scene, moved, content.options.strips);
        add_node(scene, names(name), add_mesh(scene, name, moved_ids, pose), node_of_placed(moved));
    }
}

}  // namespace

TextureFilter baked_filter(const AtlasOptions& atlas) {
    if (atlas.overscan == Overscan::nearest) return TextureFilter::nearest;
    const bool plain = atlas.kind == AtlasKind::patch || has_outlines(atlas.kind);
    return plain ? TextureFilter::mip : TextureFilter::linear;
}

nlohmann::ordered_json gltf_sampler(const AtlasOptions& atlas) {
    const TextureFilter wanted = baked_filter(atlas);
    const int filter = wanted == TextureFilter::nearest ? gl_nearest : gl_linear;
    const bool levels = wanted == TextureFilter::mip;
    return {{"magFilter", filter},
            {"minFilter", levels ? int(gl_linear_mipmap_linear) : filter},
            {"wrapS", int(gl_clamp_to_edge)},
            {"wrapT", int(gl_clamp_to_edge)}};
}

nlohmann::ordered_json burl_extras(const SceneContent& content) {
    const AtlasOptions& atlas = content.atlas.options;
    const std::string& recipe = content.options.recipe_json;
    Json burl = Json::object();
    if (content.options.vertex_colors.empty())
        burl = {{"atlas", to_string(atlas.kind)},
                {"overscan", to_string(atlas.overscan)},
                {"size", atlas.size}};
    if (atlas.kind == AtlasKind::quad) burl["weight"] = to_string(atlas.weight);
    if (!recipe.empty()) burl["recipe"] = recipe;
    if (content.options.shares.empty()) return burl;
    burl.erase("recipe");
    for (const ExportShare& share : content.options.shares)
        burl["recipes"].push_back(share.recipe_json);
    return burl;
}

std::vector<std::uint32_t> strip_indices(std::span<const std::uint32_t> list, StripCounts& counts) {
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < list.size(); i += 3)
        triangles.push_back({list[i], list[i + 1], list[i + 2]});
    const TriangleStrips strips = triangle_strips(triangles);
    std::vector<std::uint32_t> all = joined(strips);
    counts.add(strips, triangles.size(), all.size());
    return all;
}

std::span<const std::uint8_t> padding_after(std::uint64_t bytes) {
    static constexpr std::array<std::uint8_t, 3> zeros{};
    return {zeros.data(), std::size_t(-bytes % 4)};
}

GltfScene build_gltf_scene(const SceneContent& content, std::span<const PartVertices> vertices) {
    GltfScene scene;
    scene.json["asset"] = {{"version", "2.0"},
                           {"generator", "Burl " BURL_VERSION},
                           {"extras", {{"burl", burl_extras(content)}}}};
    scene.json["scene"] = 0;
    scene.json["scenes"] = Json::array({{{"nodes", Json::array()}}});
    for (const char* array : {"nodes", "meshes", "accessors", "bufferViews"}) {
        scene.json[array] = Json::array();
    }
    UniqueNames names;
    for (const PartVertices& part : vertices) add_part(scene, content, part, names);
    if (content.options.pose && !content.options.pose_keys.keys.empty())
        add_animation(scene, content.options.pose_keys);
    add_material(scene.json, content);
    if (content.options.vertex_colors.empty())
        scene.json["samplers"] = Json::array({gltf_sampler(content.atlas.options)});
    return scene;
}

}  // namespace burl
