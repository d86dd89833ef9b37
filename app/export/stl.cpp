// Binary STL output: triangles and their normals, which is all that the format holds.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "app/export/formats.h"
#include "app/export/placed_triangles.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

void add_word(std::string& text, std::uint32_t word) {
    for (int k = 0; k < 4; ++k) text.push_back(char(word >> (8 * k) & 0xffu));
}

void add_vector(std::string& text, const Vec3f& v) {
    for (int k = 0; k < 3; ++k) add_word(text, std::bit_cast<std::uint32_t>(v[k] + 0.0f));
}

/// The unit normal of the corners in order, as they are written; 0, which readers replace, for a
/// triangle without area.
Vec3f facet_normal(const std::array<Vec3f, 3>& p) {
    const Vec3d u = Vec3d(p[1]) - Vec3d(p[0]), v = Vec3d(p[2]) - Vec3d(p[0]);
    const double scale = std::max(glm::length(u), glm::length(v));
    const Vec3d normal = scale > 0.0 ? glm::cross(u / scale, v / scale) : Vec3d(0.0);
    const double length = glm::length(normal);
    return length > 0.0 ? Vec3f(normal / length) : Vec3f(0.0f);
}

/// Throws Error(unsupported) for a point beyond the range of floats.
Vec3f float_point(const SceneContent& content, const Vec3d& point) {
    const Vec3f result(point);
    if (!std::isfinite(result.x) || !std::isfinite(result.y) || !std::isfinite(result.z))
        throw Error(ExitCode::unsupported,
                    fmt::format("{}: a point lies farther than the 32-bit floats of an .stl reach; "
                                "write a .ply or .obj instead",
                                content.path));
    return result;
}

}  // namespace

AtomicFile write_stl(const SceneContent& content) {
    const PlacedTriangles what = placed_triangles(content);
    std::string text = "Burl " BURL_VERSION;
    text.resize(80, ' ');
    add_word(text, std::uint32_t(what.triangles.size()));
    for (const Triangle& triangle : what.triangles) {
        std::array<Vec3f, 3> corners;
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = float_point(content, what.points[triangle[k]]);
        add_vector(text, facet_normal(corners));
        for (const Vec3f& corner : corners) add_vector(text, corner);
        text.append(2, '\0');
    }
    if (content.options.tell)
        content.options.tell("an .stl holds no colour; the surface alone is written");
    AtomicFile file(content.path);
    file.write(text);
    return file;
}

}  // namespace burl
