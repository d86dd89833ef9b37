#include "app/export/obj_text.h"

#include <bit>

#include <fmt/compile.h>

#include "app/base/unique_rows.h"

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
    return name.empty() ? "mesh" : name;
}

std::string without_spaces(std::string name) {
    for (char& c : name)
        if (static_cast<unsigned char>(c) <= ' ' || c == '#' || c == '\x7f') c = '_';
    return name;
}

CornerLines corner_lines(const Atlas& atlas, std::span<const Vec3f> normals) {
    CornerLines out;
    UniqueRows<4> uv_rows(normals.size() / 2);
    UniqueRows<3> normal_rows(normals.size() / 2);
    const Vec2d size = atlas.extent();
    for (std::size_t c = 0; c < normals.size(); ++c) {
        const Vec2d& texel = atlas.corners[c / 3][c % 3];
        const Vec2d uv(texel.x / size.x, (size.y - texel.y) / size.y);
        const auto u = words(uv.x), v = words(uv.y);
        const std::size_t known = uv_rows.rows().size();
        out.uv.push_back(1 + uv_rows.insert({u[0], u[1], v[0], v[1]}));
        if (uv_rows.rows().size() > known) {
            put(out.text, FMT_COMPILE("vt {} {}\n"), uv.x + 0.0, uv.y + 0.0);
        }
        const Vec3f& n = normals[c];
        out.normal.push_back(1 + normal_rows.insert({word(n.x), word(n.y), word(n.z)}));
        if (normal_rows.rows().size() > out.normals.size()) out.normals.push_back(n + 0.0f);
    }
    return out;
}

void print_point(ObjText& text, const Vec3d& p) {
    put(text, FMT_COMPILE("v {} {} {}\n"), p.x + 0.0, p.y + 0.0, p.z + 0.0);
}

void print_normal(ObjText& text, const Vec3f& n) {
    put(text, FMT_COMPILE("vn {} {} {}\n"), n.x, n.y, n.z);
}

}  // namespace burl
