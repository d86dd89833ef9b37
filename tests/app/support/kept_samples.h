#pragma once
// glTF documents with what other programs put into them, made here, for tests of what a bake keeps.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "atlas/base/json.h"

namespace burl {

/// A glTF in the making: JSON, and one buffer that becomes a data uri.
class GltfDraft {
  public:
    using Json = nlohmann::ordered_json;
    Json json = {{"asset", {{"version", "2.0"}, {"copyright", "nobody"}}},
                 {"scene", 0},
                 {"scenes", Json::array({{{"nodes", {0}}}})},
                 {"nodes", Json::array({{{"mesh", 0}, {"name", "bar node"}}})},
                 {"meshes", Json::array()},
                 {"accessors", Json::array()},
                 {"bufferViews", Json::array()}};

    template <class Value>
    std::size_t view(const std::vector<Value>& values, Json extra = Json::object()) {
        bytes_.resize((bytes_.size() + 3) / 4 * 4);
        const std::size_t size = values.size() * sizeof(Value);
        extra.update({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", size}});
        json["bufferViews"].push_back(extra);
        bytes_.resize(bytes_.size() + size);
        std::memcpy(bytes_.data() + bytes_.size() - size, values.data(), size);
        return json["bufferViews"].size() - 1;
    }

    /// An accessor over all components of `values`.
    template <class Value>
    std::size_t add(const std::vector<Value>& values, int type, const char* shape,
                    std::size_t components, Json extra = Json::object()) {
        const std::size_t number = view(values);
        extra.update({{"bufferView", number},
                      {"componentType", type},
                      {"count", values.size() / components},
                      {"type", shape}});
        json["accessors"].push_back(extra);
        return json["accessors"].size() - 1;
    }
    std::size_t floats(const std::vector<float>& values, std::size_t components) {
        static const std::map<std::size_t, const char*> shapes{
            {1, "SCALAR"}, {2, "VEC2"}, {3, "VEC3"}, {4, "VEC4"}, {16, "MAT4"}};
        return add(values, 5126, shapes.at(components), components);
    }
    /// Floats with the bounds that positions and times need.
    std::size_t bounded(const std::vector<float>& values, std::size_t components) {
        const std::size_t number = floats(values, components);
        add_bounds(json["accessors"][number], values, components);
        return number;
    }
    template <class Value>
    static void add_bounds(Json& accessor, const std::vector<Value>& values,
                           std::size_t components) {
        for (std::size_t k = 0; k < components; ++k) {
            Value low = values[k], high = low;
            for (std::size_t i = k; i < values.size(); i += components)
                low = std::min(low, values[i]), high = std::max(high, values[i]);
            accessor["min"].push_back(low);
            accessor["max"].push_back(high);
        }
    }

    std::string text() const {
        Json whole = json;
        whole["buffers"] =
            Json::array({{{"byteLength", bytes_.size()},
                          {"uri", "data:application/octet-stream;base64," + base64(bytes_)}}});
        return whole.dump();
    }
    static std::string base64(const std::vector<std::uint8_t>& bytes) {
        static constexpr char digits[] =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string text;
        for (std::size_t i = 0; i < bytes.size(); i += 3) {
            std::uint32_t word = 0;
            for (std::size_t k = 0; k < 3; ++k)
                word = word << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
            for (std::size_t k = 0; k < 4; ++k)
                text += i + k > bytes.size() ? '=' : digits[word >> (18 - 6 * k) & 63];
        }
        return text;
    }

  private:
    std::vector<std::uint8_t> bytes_;
};

/// A bar along y with a round cross section: rings of vertices with a seam in their texture
/// coordinates.
struct BarArrays {
    static constexpr std::size_t around = 10, along = 9;
    std::vector<float> positions, normals, uvs, colors, weights;
    std::vector<std::uint8_t> joints;
    std::vector<std::uint16_t> indices;

    BarArrays() {
        for (std::size_t j = 0; j < along; ++j)
            for (std::size_t i = 0; i <= around; ++i) {
                const double angle = 2.0 * M_PI * double(i % around) / double(around);
                const float c = float(std::cos(angle)), s = float(std::sin(angle));
                const float y = float(j) / 4.0f, share = y / 2.0f;
                positions.insert(positions.end(), {c * (0.3f + 0.05f * y), y, s * 0.35f});
                normals.insert(normals.end(), {c, 0.0f, s});
                uvs.insert(uvs.end(), {float(i) / float(around), share});
                colors.insert(colors.end(), {share, 0.5f, 1.0f - share, 1.0f});
                joints.insert(joints.end(), {0, 1, 0, 0});
                weights.insert(weights.end(), {1.0f - share, share, 0.0f, 0.0f});
                if (share == 0.0f) joints[joints.size() - 3] = 0;
            }
        for (std::size_t j = 0; j + 1 < along; ++j)
            for (std::size_t i = 0; i < around; ++i) {
                const auto a = std::uint16_t(j * (around + 1) + i), b = std::uint16_t(a + 1),
                           c = std::uint16_t(a + around + 1), d = std::uint16_t(c + 1);
                indices.insert(indices.end(), {a, c, b, b, c, d});
            }
        for (std::size_t v = 0; v < weights.size() / 4; ++v)
            if (weights[4 * v] == 0.0f) joints[4 * v] = 0;
    }
    std::size_t count() const { return positions.size() / 3; }
};

/// A PNG of one red texel.
inline constexpr const char* red_png =
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4z8AAAAMBAQDJ/pLvAAAAAElFTkSuQmCC";

/// A draft with one mesh: the bar with normals and texture coordinates.
struct Bar : GltfDraft {
    BarArrays arrays;

    Bar() {
        json["meshes"].push_back({{"name", "bar"}, {"primitives", Json::array({primitive()})}});
    }
    Json primitive() {
        return {{"attributes",
                 {{"POSITION", bounded(arrays.positions, 3)},
                  {"NORMAL", floats(arrays.normals, 3)},
                  {"TEXCOORD_0", floats(arrays.uvs, 2)}}},
                {"indices", add(arrays.indices, 5123, "SCALAR", 1)}};
    }
    Json& first() { return json["meshes"][0]["primitives"][0]; }
    Json& attributes() { return first()["attributes"]; }
    void use(const char* extension) { json["extensionsUsed"].push_back(extension); }
    std::size_t material(Json value) {
        json["materials"].push_back(std::move(value));
        return json["materials"].size() - 1;
    }
    std::size_t add_texture(const char* name) {
        json["images"].push_back(
            {{"name", name}, {"uri", std::string("data:image/png;base64,") + red_png}});
        json["textures"].push_back({{"source", json["images"].size() - 1}, {"name", name}});
        return json["textures"].size() - 1;
    }
    /// A second mesh of the same form in a node beside.
    void add_second_mesh(const char* name) {
        json["meshes"].push_back({{"name", name}, {"primitives", Json::array({primitive()})}});
        json["nodes"].push_back(
            {{"mesh", json["meshes"].size() - 1}, {"name", name}, {"translation", {2, 0, 0}}});
        json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
    }
    void add_skin() {
        attributes()["JOINTS_0"] = add(arrays.joints, 5121, "VEC4", 4);
        attributes()["WEIGHTS_0"] = floats(arrays.weights, 4);
        add_joints();
    }
    void add_joints() {
        std::vector<float> inverse(48, 0.0f);
        for (std::size_t m = 0; m < 3; ++m)
            for (std::size_t k = 0; k < 4; ++k) inverse[16 * m + 5 * k] = 1.0f;
        inverse[16 + 13] = -1.0f;
        json["nodes"][0]["skin"] = 0;
        json["nodes"].push_back({{"name", "hip"}, {"children", {2, 3}}});
        json["nodes"].push_back({{"name", "knee"}, {"translation", {0, 1, 0}}});
        json["nodes"].push_back({{"name", "tail"}});
        json["scenes"][0]["nodes"].push_back(1);
        json["skins"] = Json::array({{{"name", "legs"},
                                      {"joints", {1, 2, 3}},
                                      {"inverseBindMatrices", floats(inverse, 16)}}});
    }
    void add_animation(int node, const char* path, const std::vector<float>& values,
                       std::size_t components, const char* interpolation = "LINEAR") {
        const std::size_t times = bounded({0.0f, 0.5f, 1.25f}, 1);
        json["animations"].push_back(
            {{"name", fmt_name(path)},
             {"channels",
              Json::array({{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}})},
             {"samplers", Json::array({{{"input", times},
                                        {"output", floats(values, components)},
                                        {"interpolation", interpolation}}})}});
    }
    static std::string fmt_name(const char* path) { return std::string("move ") + path; }
    void bend_knee() {
        add_animation(2, "rotation", {0, 0, 0, 1, 0, 0, 0.38268343f, 0.92387953f, 0, 0, 0, 1}, 4);
    }
    std::vector<float> bulge(float by) const {
        std::vector<float> changes;
        for (std::size_t v = 0; v < arrays.count(); ++v) {
            const float much = by * arrays.positions[3 * v + 1];
            changes.insert(changes.end(), {much * arrays.normals[3 * v], 0.1f * much,
                                           much * arrays.normals[3 * v + 2]});
        }
        return changes;
    }
    void add_targets() {
        first()["targets"] = Json::array(
            {{{"POSITION", bounded(bulge(0.3f), 3)}, {"NORMAL", floats(bulge(0.01f), 3)}},
             {{"POSITION", bounded(bulge(-0.2f), 3)}}});
        json["meshes"][0]["weights"] = {0.25, 0.0};
        json["meshes"][0]["extras"] = {{"targetNames", {"fat", "thin"}}};
    }
};

/// The samples by name; each is the text of a .gltf.
std::map<std::string, std::string> kept_samples();

}  // namespace burl
