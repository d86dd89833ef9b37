// Meshes of slivers and of triangles smaller than a texel, in every kind of atlas.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "app/bench/meshes.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/edit/recipe_json.h"
#include "tests/stability/checks.h"

namespace burl {

namespace {

/// Returns a strip of `count` quadrilaterals, each `length` long and length / aspect wide.
Mesh sliver_strip(std::uint32_t count, double length, double aspect) {
    Mesh mesh;
    mesh.name = "slivers";
    for (std::uint32_t i = 0; i <= count; ++i)
        for (const double along : {0.0, length})
            mesh.positions.emplace_back(along, 0.3 * along, i * length / aspect);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t a = 2 * i;
        mesh.triangles.push_back({a, a + 1, a + 3});
        mesh.triangles.push_back({a, a + 3, a + 2});
    }
    mesh.parts.push_back({mesh.name, 0, std::uint32_t(mesh.triangles.size())});
    return mesh;
}

struct MeshSubject {
    Mesh mesh;
    Recipe recipe;
    std::string input;
};

MeshSubject subject(Mesh mesh, AtlasKind kind, std::uint32_t size, SolidSpace space) {
    MeshSubject one{std::move(mesh), load_recipe("marble"), {}};
    one.recipe.atlas.kind = kind, one.recipe.atlas.size = size, one.recipe.atlas.tries = 1;
    one.recipe.solid = {space, 3.0};
    one.input = fmt::format("{}, {} triangles, {} atlas of {}", one.mesh.name,
                            one.mesh.triangles.size(), to_string(kind), size);
    return one;
}

std::vector<MeshSubject> mesh_subjects(StabilityChoice choice) {
    const bool full = choice != StabilityChoice::thinned;
    std::vector<MeshSubject> all;
    for (const AtlasKind kind : {AtlasKind::uniform, AtlasKind::area, AtlasKind::length,
                                 AtlasKind::quad, AtlasKind::patch}) {
        for (const double aspect : {1e3, 1e6})
            for (const double length : {1.0, 1e6})
                if (full || aspect > length)
                    all.push_back(
                        subject(sliver_strip(40, length, aspect), kind, 64, SolidSpace::unit));
        all.push_back(subject(sliver_strip(40, 1e3, 1e6), kind, 64, SolidSpace::object));
        // A quad atlas accepts triangles of any size; the other atlases get the smallest size that
        // fits.
        Mesh small = bumpy_sphere(full ? 20'000 : 1'000);
        const std::uint32_t fits = smallest_size(small.triangles.size(), {.kind = kind});
        const std::uint32_t size = kind == AtlasKind::quad ? (full ? 64 : 16) : fits + 16;
        all.push_back(subject(std::move(small), kind, size, SolidSpace::unit));
    }
    return all;
}

long double exact_cross(const Vec2d& a, const Vec2d& b) {
    return (long double)(a.x) * b.y - (long double)(a.y) * b.x;
}

/// Returns the barycentric coordinates of a texel's centre; empty outside the triangle or without
/// area.
std::optional<Vec3d> place_in_triangle(const std::array<Vec2d, 3>& corners, const Vec2d& centre) {
    const auto& [a, b, c] = corners;
    const long double area = exact_cross(b - a, c - a);
    if (area == 0.0L) return {};
    const Vec3d weights(double(exact_cross(b - centre, c - centre) / area),
                        double(exact_cross(c - centre, a - centre) / area),
                        double(exact_cross(a - centre, b - centre) / area));
    return weights.x >= 0.0 && weights.y >= 0.0 && weights.z >= 0.0 ? std::optional(weights)
                                                                    : std::nullopt;
}

}  // namespace

StabilityGroup mesh_group(StabilityChoice choice) {
    StabilityGroup group{"slivers and small triangles", {}};
    for (MeshSubject& one : mesh_subjects(choice)) {
        Pipeline pipeline(std::move(one.mesh));
        pipeline.set_recipe(one.recipe);
        group.cases.push_back({std::move(one.input), *plain_texture(one.recipe.texture),
                               pipeline.solid(), texture_from_solid(one.recipe)});
    }
    return group;
}

StabilityRow check_texel_points(StabilityChoice choice) {
    StabilityRow row;
    row.group = "slivers: points of texels";
    for (MeshSubject& one : mesh_subjects(choice)) {
        Pipeline pipeline(std::move(one.mesh));
        pipeline.set_recipe(one.recipe);
        ++row.cases;
        const SolidAtlas& solid = pipeline.solid();
        const Mesh& mesh = pipeline.atlas_mesh();
        const std::vector<Vec3d> points =
            map_positions(mesh, solid_from_mesh(pipeline.mesh(), one.recipe.solid.space));
        double size = 0.0;
        for (const Vec3d& p : points) size = std::max(size, glm::length(p));
        for (std::size_t y = 0; y < solid.size; ++y)
            for (const Span& span : solid.row(y)) {
                // A triangle shown a second time, turned by 180 degrees.
                if (span.map >= mesh.triangles.size()) continue;
                const Triangle& corners = mesh.triangles[span.map];
                for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                    const auto weights = place_in_triangle(pipeline.atlas().corners[span.map],
                                                           {x + 0.5, double(y) + 0.5});
                    if (!weights) continue;
                    Vec3d point(0.0);
                    for (std::size_t k = 0; k < 3; ++k)
                        point += (*weights)[int(k)] * points[corners[k]];
                    const double error =
                        glm::length(solid.maps[span.map](x, std::int64_t(y)) - point);
                    row.note(error, 1e-14 * size, [&] {
                        return fmt::format("{}, triangle {}, texel ({}, {})", one.input, span.map,
                                           x, y);
                    });
                }
            }
    }
    return row;
}

}  // namespace burl
