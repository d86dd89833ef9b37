// Linear-time counts over a finished mesh; duplicates are found with one hash table of triangle
// ids.
#include "atlas/mesh/mesh_checks.h"

#include <algorithm>
#include <bit>

#include "atlas/mesh/mesh_builder.h"

namespace burl {
namespace {

Triangle sorted(Triangle t) {
    if (t[0] > t[1]) std::swap(t[0], t[1]);
    if (t[1] > t[2]) std::swap(t[1], t[2]);
    if (t[0] > t[1]) std::swap(t[0], t[1]);
    return t;
}

std::size_t hash_of(const Triangle& points) {
    std::uint64_t h = points[0] * 0x9e3779b97f4a7c15ull + points[1];
    h = (h ^ h >> 32) * 0xd6e8feb86659fd93ull + points[2];
    h = (h ^ h >> 32) * 0xd6e8feb86659fd93ull;
    return h ^ h >> 32;
}

}  // namespace

std::uint64_t count_degenerate_triangles(const Mesh& mesh) {
    const double side = bounding_box(mesh).longest_side();
    if (!(side > 0.0)) return mesh.triangles.size();
    std::uint64_t count = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3d ab = (mesh.positions[b] - mesh.positions[a]) / side;
        const Vec3d ac = (mesh.positions[c] - mesh.positions[a]) / side;
        const Vec3d normal = glm::cross(ab, ac);
        count += glm::dot(normal, normal) <= 4.0 * zero_area * zero_area;
    }
    return count;
}

std::uint64_t count_duplicate_triangles(const Mesh& mesh) {
    const std::size_t slots = std::bit_ceil(2 * mesh.triangles.size() + 64);
    std::vector<std::uint32_t> table(slots, 0);  // triangle number + 1
    std::uint64_t count = 0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Triangle key = sorted(mesh.triangles[t]);
        std::size_t at = hash_of(key) & (slots - 1);
        while (table[at] != 0 && sorted(mesh.triangles[table[at] - 1]) != key)
            at = (at + 1) & (slots - 1);
        if (table[at] != 0)
            ++count;
        else
            table[at] = t + 1;
    }
    return count;
}

}  // namespace burl
