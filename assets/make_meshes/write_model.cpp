// Text numbers are the shortest that read back as the same double; binary coordinates are float32,
// which loses nothing (model.h).
#include "assets/make_meshes/write_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>

namespace burl {
namespace {

using Text = std::back_insert_iterator<std::string>;

template <typename Value>
void append(std::string& bytes, Value value, bool big_endian = false) {
    static_assert(std::endian::native == std::endian::little);
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (big_endian) std::reverse(raw, raw + sizeof value);
    bytes.append(raw, sizeof value);
}

void append(std::string& bytes, const Vec3d& v, bool big_endian = false) {
    for (int k = 0; k < 3; ++k) append(bytes, static_cast<float>(v[k]), big_endian);
}

std::string ply_header(const Model& model, const char* format, const char* scalar) {
    return fmt::format(
        "ply\nformat {} 1.0\ncomment made by burl-meshes\nelement vertex {}\n"
        "property {} x\nproperty {} y\nproperty {} z\nelement face {}\n"
        "property list uchar int vertex_indices\nend_header\n",
        format, model.points().size(), scalar, scalar, scalar, model.triangles().size());
}

Vec3d unit_normal(const Model& model, const std::array<std::uint32_t, 3>& t) {
    const auto& points = model.points();
    const Vec3d n = glm::cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
    const double length = glm::length(n);
    return length > 0.0 ? n / length : Vec3d(0.0);
}

}  // namespace

std::string obj_text(const Model& model) {
    std::string text = "# made by burl-meshes\n";
    for (const Vec3d& p : model.points()) fmt::format_to(Text(text), "v {} {} {}\n", p.x, p.y, p.z);
    for (const auto& t : model.triangles())
        fmt::format_to(Text(text), "f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
    return text;
}

std::string off_text(const Model& model) {
    std::string text =
        fmt::format("OFF\n{} {} 0\n", model.points().size(), model.triangles().size());
    for (const Vec3d& p : model.points()) fmt::format_to(Text(text), "{} {} {}\n", p.x, p.y, p.z);
    for (const auto& t : model.triangles())
        fmt::format_to(Text(text), "3 {} {} {}\n", t[0], t[1], t[2]);
    return text;
}

std::string ply_text(const Model& model) {
    std::string text = ply_header(model, "ascii", "double");
    for (const Vec3d& p : model.points()) fmt::format_to(Text(text), "{} {} {}\n", p.x, p.y, p.z);
    for (const auto& t : model.triangles())
        fmt::format_to(Text(text), "3 {} {} {}\n", t[0], t[1], t[2]);
    return text;
}

std::string ply_bytes(const Model& model, bool big_endian) {
    std::string bytes =
        ply_header(model, big_endian ? "binary_big_endian" : "binary_little_endian", "float");
    for (const Vec3d& p : model.points()) append(bytes, p, big_endian);
    for (const auto& t : model.triangles()) {
        bytes.push_back(3);
        for (const std::uint32_t corner : t) append(bytes, corner, big_endian);
    }
    return bytes;
}

std::string stl_text(const Model& model) {
    std::string text = "solid burl\n";
    for (const auto& t : model.triangles()) {
        const Vec3d n = unit_normal(model, t);
        fmt::format_to(Text(text), "facet normal {} {} {}\n  outer loop\n", n.x, n.y, n.z);
        for (const std::uint32_t corner : t) {
            const Vec3d& p = model.points()[corner];
            fmt::format_to(Text(text), "    vertex {} {} {}\n", p.x, p.y, p.z);
        }
        text += "  endloop\nendfacet\n";
    }
    return text + "endsolid burl\n";
}

std::string stl_bytes(const Model& model) {
    std::string bytes = "made by burl-meshes";
    bytes.resize(80, ' ');
    append(bytes, static_cast<std::uint32_t>(model.triangles().size()));
    for (const auto& t : model.triangles()) {
        append(bytes, unit_normal(model, t));
        for (const std::uint32_t corner : t) append(bytes, model.points()[corner]);
        append(bytes, std::uint16_t{0});
    }
    return bytes;
}

std::string glb_bytes(const Model& model) {
    std::string binary;
    Vec3d low = model.points().front(), high = low;
    for (const Vec3d& p : model.points()) {
        append(binary, p);
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const std::size_t index_offset = binary.size();
    for (const auto& t : model.triangles())
        for (const std::uint32_t corner : t) append(binary, corner);
    const std::size_t index_size = binary.size() - index_offset;

    std::string json = fmt::format(
        R"({{"asset":{{"version":"2.0","generator":"burl-meshes"}},"scene":0,"scenes":[{{"nodes":[0]}}],)"
        R"("nodes":[{{"mesh":0}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],)"
        R"("accessors":[{{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3",)"
        R"("min":[{},{},{}],"max":[{},{},{}]}},)"
        R"({{"bufferView":1,"componentType":5125,"count":{},"type":"SCALAR"}}],)"
        R"("bufferViews":[{{"buffer":0,"byteLength":{},"target":34962}},)"
        R"({{"buffer":0,"byteOffset":{},"byteLength":{},"target":34963}}],"buffers":[{{"byteLength":{}}}]}})",
        model.points().size(), low.x, low.y, low.z, high.x, high.y, high.z,
        3 * model.triangles().size(), index_offset, index_offset, index_size, binary.size());
    json.resize((json.size() + 3) / 4 * 4, ' ');

    std::string bytes = "glTF";
    append(bytes, std::uint32_t{2});
    append(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + binary.size()));
    append(bytes, static_cast<std::uint32_t>(json.size()));
    bytes += "JSON" + json;
    append(bytes, static_cast<std::uint32_t>(binary.size()));
    bytes.append("BIN\0", 4);
    return bytes + binary;
}

}  // namespace burl
