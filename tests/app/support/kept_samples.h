#pragma once
// glTF documents with what other programs put into them, made here, for tests of what a bake keeps.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

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

/// The samples by name; each is the text of a .gltf.
std::map<std::string, std::string> kept_samples();

}  // namespace burl
