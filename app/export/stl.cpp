// Binary STL output: triangles and their normals, which is all that the format holds.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

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

/// The unit normal of the corners in order; 0, which readers replace, for a triangle without area.
Vec3f facet_normal(const std::array<Vec3d, 3>& p) {
    const Vec3d u = p[1] - p[0], v = p[2] - p[0];
    const double scale = std::max(glm::length(u), glm::length(v));
    const Vec3d normal = scale > 0.0 ? glm::cross(u / scale, v / scale) : Vec3d(0.0);
    const double length = glm::length(normal);
    return length > 0.0 ? Vec3f(normal / length) : Vec3f(0.0f);
}

}  // namespace

AtomicFile write_stl(const SceneContent& content) {
    const PlacedTriangles what = placed_triangles(content);
    std::string text = "Burl " BURL_VERSION;
    text.resize(80, ' ');
    add_word(text, std::uint32_t(what.triangles.size()));
    for (const Triangle& triangle : what.triangles) {
        std::array<Vec3d, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = what.points[triangle[k]];
        add_vector(text, facet_normal(corners));
        for (const Vec3d& corner : corners) {
            if (!std::isfinite(float(corner.x) + float(corner.y) + float(corner.z)))
                throw Error(ExitCode::unsupported,
                            fmt::format("{}: a point lies farther than the 32-bit floats of an "
                                        ".stl reach; write a .ply or .obj instead",
                                        content.path));
            add_vector(text, Vec3f(corner));
        }
        text.append(2, '\0');
    }
    if (content.options.tell)
        content.options.tell("an .stl holds no colour; the surface alone is written");
    AtomicFile file(content.path);
    file.write(text);
    return file;
}

}  // namespace burl
