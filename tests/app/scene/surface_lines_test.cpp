// Edges and borders against every pair of triangles of the mesh and its atlas in turn.
#include "app/scene/surface_lines.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "app/gl/draw/view_scene.h"
#include "app/surface/sample_meshes.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

/// By the mesh's own numbers: none of the scene's vertices.
struct Counted {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    std::size_t borders = 0;
    std::vector<std::uint32_t> charts;  ///< of each triangle, any numbers
};

/// Whether two sides of triangles, one edge of the mesh, have the same ends in the texture.
bool lies_together(const Atlas& atlas, const Mesh& mesh, std::size_t s, int i, std::size_t t,
                   int k) {
    const auto at = [&](std::size_t triangle, int corner) {
        return std::pair(mesh.triangles[triangle][std::size_t(corner % 3)],
                         atlas.corners[triangle][std::size_t(corner % 3)]);
    };
    for (const auto& [point, place] : {at(s, i), at(s, i + 1)})
        for (const auto& [other, its_place] : {at(t, k), at(t, k + 1)})
            if (point == other && glm::distance(place, its_place) > 1e-4) return false;
    return true;
}

Counted count(const Mesh& mesh, const Atlas& atlas) {
    const Connectivity neighbours = made::neighbours_by_brute_force(mesh);
    Counted counted;
    const std::size_t triangles = mesh.triangles.size();
    for (std::uint32_t t = 0; t < triangles; ++t) counted.charts.push_back(t);
    for (std::size_t t = 0; t < triangles; ++t)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles[t][std::size_t(k)],
                                b = mesh.triangles[t][std::size_t((k + 1) % 3)];
            counted.edges.insert(std::minmax(a, b));
            bool joined = false;
            for (std::size_t s = 0; s < triangles && !joined; ++s)
                for (int i = 0; i < 3 && s != t; ++i) {
                    const std::uint32_t c = mesh.triangles[s][std::size_t(i)],
                                        d = mesh.triangles[s][std::size_t((i + 1) % 3)];
                    if (std::minmax(a, b) != std::minmax(c, d)) continue;
                    if (!lies_together(atlas, mesh, s, i, t, k)) continue;
                    joined = true;
                    const auto [low, high] = std::minmax(counted.charts[s], counted.charts[t]);
                    const std::uint32_t kept = low, gone = high;
                    std::ranges::replace(counted.charts, gone, kept);
                }
            counted.borders += !joined;
        }
    return counted;
}

TEST(SurfaceLines, AreTheEdgesOfTheMeshAndOfItsCharts) {
    for (const char* kind : {"patch", "quad", "area"}) {
        Pipeline pipeline(made::ball(2));
        pipeline.set_recipe(
            load_recipe("marble", {"atlas.size=128", std::string("atlas.kind=") + kind}));
        const SurfaceLines lines = surface_lines(baked_scene(pipeline));
        const Counted expected = count(pipeline.atlas_mesh(), pipeline.atlas());
        EXPECT_EQ(lines.edges.size(), expected.edges.size()) << kind;
        EXPECT_EQ(lines.borders.size(), expected.borders) << kind;
        const std::set<std::uint32_t> charts(expected.charts.begin(), expected.charts.end());
        ASSERT_EQ(lines.border_begin.size(), charts.size() + 1) << kind;
        ASSERT_EQ(lines.charts.size(), 1u);
        for (std::size_t s = 0; s < expected.charts.size(); s += 7)
            for (std::size_t t = 0; t < expected.charts.size(); ++t)
                EXPECT_EQ(lines.charts[0][s] == lines.charts[0][t],
                          expected.charts[s] == expected.charts[t]);
    }
}

TEST(SurfaceLines, AnOutlineIsThatOfItsChart) {
    Pipeline pipeline(made::ball(2));
    pipeline.set_recipe(load_recipe("marble", {"atlas.size=128", "atlas.kind=quad"}));
    const Scene scene = baked_scene(pipeline);
    const SurfaceLines lines = surface_lines(scene);
    const Surface& surface = scene.surfaces.front();
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
        const auto outline = lines.outline(lines.charts[0][t]);
        EXPECT_EQ(outline.size(), 4u);  // of a pair
        Vec2d low(1.0), high(0.0);
        for (const BorderLine& border : outline) {
            low = glm::min(low, glm::min(border.from_uv, border.to_uv));
            high = glm::max(high, glm::max(border.from_uv, border.to_uv));
            EXPECT_LT(std::abs(glm::dot(border.normal, border.line.to - border.line.from)),
                      1e-6 * glm::length(border.normal));
        }
        for (const std::uint32_t corner : surface.triangles[t]) {
            EXPECT_TRUE(glm::all(glm::lessThanEqual(low, surface.uvs[corner])));
            EXPECT_TRUE(glm::all(glm::greaterThanEqual(high, surface.uvs[corner])));
        }
    }
}

}  // namespace
}  // namespace burl
