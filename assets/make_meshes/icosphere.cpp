// A sphere of nearly equal triangles: an icosahedron, each triangle split into four and the new
// points pushed out to the sphere, a few times over.
#include <glm/geometric.hpp>
#include <numbers>

#include "assets/make_meshes/model.h"

namespace burl {
namespace {

void add_split(Model& model, const Vec3d& a, const Vec3d& b, const Vec3d& c, int levels) {
    if (levels == 0) {
        model.triangle(a, b, c);
        return;
    }
    const Vec3d ab = glm::normalize(a + b), bc = glm::normalize(b + c), ca = glm::normalize(c + a);
    add_split(model, a, ab, ca, levels - 1);
    add_split(model, ab, b, bc, levels - 1);
    add_split(model, ca, bc, c, levels - 1);
    add_split(model, ab, bc, ca, levels - 1);
}

}  // namespace

Model make_icosphere(int levels) {
    constexpr double g = std::numbers::phi;
    const std::array<Vec3d, 12> corners{Vec3d(-1, g, 0),  Vec3d(1, g, 0),   Vec3d(-1, -g, 0),
                                        Vec3d(1, -g, 0),  Vec3d(0, -1, g),  Vec3d(0, 1, g),
                                        Vec3d(0, -1, -g), Vec3d(0, 1, -g),  Vec3d(g, 0, -1),
                                        Vec3d(g, 0, 1),   Vec3d(-g, 0, -1), Vec3d(-g, 0, 1)};
    constexpr std::array<std::array<std::size_t, 3>, 20> faces{
        {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
         {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
         {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    Model model;
    for (const auto& [a, b, c] : faces)
        add_split(model, glm::normalize(corners[a]), glm::normalize(corners[b]),
                  glm::normalize(corners[c]), levels);
    return model;
}

}  // namespace burl
