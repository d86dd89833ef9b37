#pragma once
// A builder of small glTF files for tests: accessors are appended to one buffer, which is written
// inside the JSON, in a GLB, or in a file of its own.

#include "atlas/base/json.h"
#include "tests/atlas/support/mesh_files.h"

namespace burl::test {

class GltfFile {
  public:
    using Json = nlohmann::json;

    GltfFile() { root["asset"]["version"] = "2.0"; }

    /// Appends bytes (aligned to four) as a bufferView; returns its index.
    int view(const std::string& data, int stride = 0) {
        binary.resize((binary.size() + 3) / 4 * 4, '\0');
        Json v{{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", data.size()}};
        if (stride != 0) v["byteStride"] = stride;
        binary += data;
        root["bufferViews"].push_back(v);
        return static_cast<int>(root["bufferViews"].size()) - 1;
    }
    /// Appends an accessor over a view (-1: none); returns its index.
    int accessor(int buffer_view, int component_type, const std::string& type, std::size_t count,
                 const Json& more = Json::object()) {
        Json a{{"componentType", component_type}, {"type", type}, {"count", count}};
        if (buffer_view >= 0) a["bufferView"] = buffer_view;
        a.update(more);
        root["accessors"].push_back(a);
        return static_cast<int>(root["accessors"].size()) - 1;
    }
    template <typename Value>
    static std::string packed(const std::vector<Value>& values) {
        std::string bytes;
        for (const Value value : values) bytes += bytes_of(value);
        return bytes;
    }
    int floats(const std::vector<float>& values, const std::string& type, std::size_t components) {
        return accessor(view(packed(values)), 5126, type, values.size() / components);
    }
    int positions(const std::vector<float>& values) { return floats(values, "VEC3", 3); }
    int shorts(const std::vector<std::uint16_t>& indices) {
        return accessor(view(packed(indices)), 5123, "SCALAR", indices.size());
    }
    /// Appends a mesh of one primitive; returns its index.
    int mesh(const Json& primitive) {
        root["meshes"].push_back({{"primitives", Json::array({primitive})}});
        return static_cast<int>(root["meshes"].size()) - 1;
    }
    /// Appends a mesh of the triangle (0,0,0) (1,0,0) (0,1,0); returns its index.
    int triangle() {
        return mesh({{"attributes", {{"POSITION", positions({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}});
    }
    int node(const Json& content) {
        root["nodes"].push_back(content);
        return static_cast<int>(root["nodes"].size()) - 1;
    }

    static std::string base64(const std::string& data) {
        const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string code;
        for (std::size_t i = 0; i < data.size(); i += 3) {
            unsigned group = 0;
            for (std::size_t k = 0; k < 3; ++k)
                group = group << 8 |
                        (i + k < data.size() ? static_cast<unsigned char>(data[i + k]) : 0u);
            for (std::size_t k = 0; k < 4; ++k)
                code += i + k <= data.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
        }
        return code;
    }
    std::string gltf() const {
        Json all = root;
        if (!all.contains("buffers") && !binary.empty())
            all["buffers"] =
                Json::array({{{"byteLength", binary.size()},
                              {"uri", "data:application/octet-stream;base64," + base64(binary)}}});
        return all.dump(1);
    }
    std::string glb() const {
        Json all = root;
        std::string chunk = binary;
        chunk.resize((chunk.size() + 3) / 4 * 4, '\0');
        if (!all.contains("buffers"))
            all["buffers"] = Json::array({{{"byteLength", binary.size()}}});
        std::string json = all.dump();
        json.resize((json.size() + 3) / 4 * 4, ' ');
        return "glTF" + bytes_of(2u) +
               bytes_of(static_cast<std::uint32_t>(28 + json.size() + chunk.size())) +
               bytes_of(static_cast<std::uint32_t>(json.size())) + "JSON" + json +
               bytes_of(static_cast<std::uint32_t>(chunk.size())) + std::string("BIN\0", 4) + chunk;
    }
    Mesh read(const ReadOptions& options = {}) const {
        return read_text("a.gltf", gltf(), options);
    }

    Json root;
    std::string binary;
};

}  // namespace burl::test
