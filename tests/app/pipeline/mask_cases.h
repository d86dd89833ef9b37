#pragma once
// Recipes and meshes for tests of masks of the shape.
#include <string>
#include <vector>

#include <fmt/format.h>

#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/recipe.h"
#include "tests/app/support/sample_scene.h"
#include "tests/atlas/support/made_shapes.h"

namespace burl {

inline Recipe mask_recipe(const std::string& texture,
                          const std::vector<std::string>& settings = {}) {
    return parse_recipe(fmt::format(R"({{"texture": {}, "atlas": {{"size": 128}}}})", texture), "r",
                        settings);
}

/// A torus with a plate through it, 3.2 units long.
inline Mesh ring_and_plate() {
    Mesh mesh = made::both(made::torus(1.0, 0.4, 24, 16),
                           made::cuboid({-0.2, -0.2, -1.5}, {1.8, 0.2, 1.5}));
    add_whole_part(mesh);
    return mesh;
}

/// A square of side 2 with attributes that are linear in its points: colours (x / 2, y / 4, 1, 1 /
/// 2) and texture coordinates (3 x + 1, 2 y).
inline Mesh drawn_sheet() {
    Mesh mesh = made::sheet({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle) {
            const Vec3d& p = mesh.positions[corner];
            mesh.corners.colors.push_back({0.5 * p.x, 0.25 * p.y, 1.0, 0.5});
            mesh.corners.uvs.push_back({3.0 * p.x + 1.0, 2.0 * p.y});
        }
    add_whole_part(mesh);
    return mesh;
}

}  // namespace burl
