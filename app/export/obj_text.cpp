#include "app/export/obj_text.h"

#include <bit>

#include <fmt/compile.h>

#include "app/base/unique_rows.h"
#include "procedural/color/srgb.h"

namespace burl {

namespace {

/// The two words of a double, with -0 as 0.
std::array<std::uint32_t, 2> words(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value + 0.0);
    return {std::uint32_t(bits), std::uint32_t(bits >> 32)};
}
/// The word of a float, with -0 as 0.
std::uint32_t word(float value) {
    return std::bit_cast<std::uint32_t>(value + 0.0f);
}

}  // namespace

std::string one_line(std::string name) {
    for (char& c : name) {
        if (static_cast<unsigned char>(c) < ' ') c = '_';
    }
    if (name.ends_with('\\')) name.back() = '_';
    return name.empty() ? "mesh" : name;
}

std::string without_spaces(std::string name) {
    for (char& c : name)
        if (static_cast<unsigned char>(c) <= ' ' || c == '#' || c == '\x7f') c = '_';
    if (name.ends_with('\\')) name.back() = '_';
    return name;
}

CornerLines corner_lines(const Atlas& atlas, std::span<const Vec3f> normals) {
    CornerLines out;
    UniqueRows<4> uv_rows(normals.size() / 2);
    UniqueRows<3> normal_rows(normals.size() / 2);
    const Vec2d size = atlas.extent();
    const auto add_uv = [&](std::size_t c) {
        const Vec2d& texel = atlas.corners[c / 3][c % 3];
        const Vec2d uv(texel.x / size.x, (size.y - texel.y) / size.y);
        const auto u = words(uv.x), v = words(uv.y);
        const std::size_t known = uv_rows.rows().size();
        out.uv.push_back(1 + uv_rows.insert({u[0], u[1], v[0], v[1]}));
        if (uv_rows.rows().size() > known) {
            put(out.text, FMT_COMPILE("vt {} {}\n"), uv.x + 0.0, uv.y + 0.0);
        }
    };
    for (std::size_t c = 0; c < normals.size(); ++c) {
        if (atlas.corners.empty())
            out.uv.push_back(0);
        else
            add_uv(c);
        const Vec3f& n = normals[c];
        out.normal.push_back(1 + normal_rows.insert({word(n.x), word(n.y), word(n.z)}));
        if (normal_rows.rows().size() > out.normals.size()) out.normals.push_back(n + 0.0f);
    }
    return out;
}

void print_corner(ObjText& text, std::size_t point, std::size_t uv, std::size_t normal) {
    if (uv == 0)
        put(text, FMT_COMPILE(" {}//{}"), point, normal);
    else
        put(text, FMT_COMPILE(" {}/{}/{}"), point, uv, normal);
}

std::vector<Vec4f> shown_colors(const SceneContent& content, const Mesh& shown) {
    const std::vector<Vec4f>& colors = content.options.vertex_colors;
    if (colors.empty()) return {};
    std::vector<Vec4f> result(shown.positions.size());
    for (std::size_t t = 0; t < shown.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            result[shown.triangles[t][k]] = colors[content.mesh.triangles[t][k]];
    return result;
}

void print_point(ObjText& text, const Vec3d& p, const Vec4f* color) {
    put(text, FMT_COMPILE("v {} {} {}"), p.x + 0.0, p.y + 0.0, p.z + 0.0);
    if (color)
        put(text, FMT_COMPILE(" {} {} {}"), float(srgb_encode(color->r)),
            float(srgb_encode(color->g)), float(srgb_encode(color->b)));
    text.push_back('\n');
}

void print_normal(ObjText& text, const Vec3f& n) {
    put(text, FMT_COMPILE("vn {} {} {}\n"), n.x, n.y, n.z);
}

}  // namespace burl
