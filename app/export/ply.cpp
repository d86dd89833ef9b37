// PLY output, binary and little endian: what Blender, MeshLab and this program read. A vertex is
// what agrees in point, texture coordinate and normal. Texture coordinates are there twice, as
// Blender reads them (s and t of vertices) and as MeshLab does (a list per face, which strips
// have no place for).
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include <fmt/format.h>

#include "app/export/formats.h"
#include "app/export/placed_triangles.h"
#include "procedural/color/srgb.h"

namespace burl {

namespace {

/// The bytes of numbers, lowest first.
class LittleEndian {
  public:
    template <class Value>
    void add(Value value) {
        auto bytes = std::bit_cast<std::array<char, sizeof(Value)>>(value);
        if constexpr (std::endian::native == std::endian::big)
            std::reverse(bytes.begin(), bytes.end());
        text.append(bytes.data(), bytes.size());
    }
    std::string text{};
};

/// Whether all points are floats, so that floats hold them.
bool are_floats(std::span<const Vec3d> points) {
    return std::ranges::all_of(points, [](const Vec3d& p) { return Vec3d(Vec3f(p)) == p; });
}

/// The path of the texture's file.
std::string texture_path(const SceneContent& content) {
    return path_beside(content.path, extension_of(content.options.coding.format));
}

/// A color as codes of sRGB, as Blender and MeshLab take colours of PLY to be.
std::array<std::uint8_t, 4> codes_of(const Vec4f& color) {
    const auto code = [](double value) {
        return std::uint8_t(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
    };
    return {code(srgb_encode(color.r)), code(srgb_encode(color.g)), code(srgb_encode(color.b)),
            code(color.a)};
}

std::string header(const SceneContent& content, const PlacedTriangles& what, bool floats) {
    const bool textured = !what.uvs.empty();
    const char* const real = floats ? "float" : "double";
    std::string text = "ply\nformat binary_little_endian 1.0\ncomment Burl " BURL_VERSION "\n";
    if (textured)
        text += fmt::format("comment TextureFile {}\n",
                            std::filesystem::path(texture_path(content)).filename().string());
    text += fmt::format("element vertex {}\n", what.points.size());
    for (const char axis : {'x', 'y', 'z'}) text += fmt::format("property {} {}\n", real, axis);
    for (const char axis : {'x', 'y', 'z'}) text += fmt::format("property float n{}\n", axis);
    if (textured) text += "property float s\nproperty float t\n";
    if (!what.colors.empty())
        for (const char* channel : {"red", "green", "blue", "alpha"})
            text += fmt::format("property uchar {}\n", channel);
    if (content.options.strips)
        return text + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
    text += fmt::format("element face {}\nproperty list uchar int vertex_indices\n",
                        what.triangles.size());
    if (textured) text += "property list uchar float texcoord\n";
    return text + "end_header\n";
}

void add_vertex(LittleEndian& out, const PlacedTriangles& what, std::size_t i, bool floats) {
    for (int k = 0; k < 3; ++k) {
        if (floats)
            out.add(float(what.points[i][k]));
        else
            out.add(what.points[i][k]);
    }
    for (int k = 0; k < 3; ++k) out.add(what.normals[i][k]);
    if (!what.uvs.empty()) {
        out.add(float(what.uvs[i].x));
        out.add(float(what.uvs[i].y));
    }
    if (!what.colors.empty())
        for (const std::uint8_t code : codes_of(what.colors[i])) out.add(code);
}

void add_face(LittleEndian& out, const PlacedTriangles& what, const Triangle& triangle) {
    out.add(std::uint8_t(3));
    for (const std::uint32_t v : triangle) out.add(v);
    if (what.uvs.empty()) return;
    out.add(std::uint8_t(6));
    for (const std::uint32_t v : triangle) {
        out.add(float(what.uvs[v].x));
        out.add(float(what.uvs[v].y));
    }
}

/// Adds all triangles as strips, each of which ends with -1 as in the files of Stanford's scans.
void add_strips(LittleEndian& out, const PlacedTriangles& what, StripCounts& counts) {
    const TriangleStrips strips = triangle_strips(what.triangles);
    const std::size_t size = strips.vertices.size() + strips.ends.size();
    counts.add(strips, what.triangles.size(), size);
    out.add(std::int32_t(size));
    std::size_t begin = 0;
    for (const std::size_t end : strips.ends) {
        for (; begin < end; ++begin) out.add(strips.vertices[begin]);
        out.add(std::int32_t(-1));
    }
}

}  // namespace

std::vector<AtomicFile> write_ply(const SceneContent& content) {
    const PlacedTriangles what = placed_triangles(content);
    const bool floats = are_floats(what.points);
    LittleEndian out{header(content, what, floats)};
    for (std::size_t i = 0; i < what.points.size(); ++i) add_vertex(out, what, i, floats);
    if (content.options.strips)
        add_strips(out, what, *content.options.strips);
    else
        for (const Triangle& triangle : what.triangles) add_face(out, what, triangle);
    if (content.options.tell && (content.options.normals || !content.options.pictures.empty()))
        content.options.tell("a .ply names the picture of the base colour alone");
    std::vector<AtomicFile> files;
    add_images(files, content, texture_path(content));
    files.emplace_back(content.path).write(out.text);
    return files;
}

}  // namespace burl
