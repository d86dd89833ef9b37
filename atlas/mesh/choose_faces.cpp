#include "atlas/mesh/choose_faces.h"

#include <limits>

namespace burl {

namespace {

/// The values of the corners of chosen triangles; empty where there are none at all.
template <class Value>
std::vector<Value> of_triangles(const std::vector<Value>& values,
                                const std::vector<std::uint32_t>& triangles) {
    std::vector<Value> chosen;
    if (values.empty()) return chosen;
    chosen.reserve(3 * triangles.size());
    for (const std::uint32_t t : triangles)
        for (std::size_t k = 0; k < 3; ++k) chosen.push_back(values[3 * std::size_t(t) + k]);
    return chosen;
}

/// Sets triangles and positions, which are numbered by first use.
void take_points(const Mesh& mesh, const std::vector<std::uint32_t>& triangles, Mesh& result) {
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(mesh.positions.size(), none);
    for (const std::uint32_t t : triangles) {
        Triangle& triangle = result.triangles.emplace_back(mesh.triangles[t]);
        for (std::uint32_t& p : triangle) {
            if (number[p] == none) {
                number[p] = std::uint32_t(result.positions.size());
                result.positions.push_back(mesh.positions[p]);
            }
            p = number[p];
        }
    }
}

}  // namespace

Mesh with_faces(const Mesh& mesh, const std::vector<char>& chosen) {
    Mesh result;
    result.name = mesh.name;
    result.notes = mesh.notes;
    std::vector<std::uint32_t> triangles;
    for (const Part& part : mesh.parts) {
        const auto first = std::uint32_t(triangles.size());
        for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count;
             ++t)
            if (chosen[mesh.source_faces[t]]) triangles.push_back(t);
        if (triangles.size() > first)
            result.parts.push_back(
                {part.name, first, std::uint32_t(triangles.size()) - first, part.instances});
    }
    take_points(mesh, triangles, result);
    result.notes.unchosen_triangles += mesh.triangles.size() - triangles.size();
    for (const std::uint32_t t : triangles) result.source_faces.push_back(mesh.source_faces[t]);
    result.corners = {
        of_triangles(mesh.corners.normals, triangles), of_triangles(mesh.corners.colors, triangles),
        of_triangles(mesh.corners.uvs, triangles), of_triangles(mesh.corners.joints, triangles),
        of_triangles(mesh.corners.weights, triangles)};
    return result;
}

}  // namespace burl
