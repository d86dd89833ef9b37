#include "app/bake/vertex_colors.h"

#include <chrono>

#include <fmt/format.h>

#include "app/base/stopwatch.h"
#include "app/pipeline/texture_color.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/lattice_check.h"
#include "atlas/base/each_index.h"
#include "atlas/base/error.h"

namespace burl {

std::vector<Vec4f> vertex_colors(const Recipe& recipe, const Mesh& mesh) {
    check_lattice(recipe, mesh);
    const FilteredColor color = shown_color(recipe, FilterKind::none);
    const Affine3 map = texture_from_mesh(recipe, mesh);
    std::vector<Vec4f> colors(mesh.positions.size());
    for_each_index(
        colors.size(),
        [&](std::size_t p) {
            const Vec4d shown = color(map(mesh.positions[p]), {});
            const Vec3d rgb = shown.a > 0.0 ? Vec3d(shown) / shown.a : Vec3d(0.0);
            colors[p] = Vec4f(Vec4d(glm::clamp(rgb, 0.0, 1.0), glm::clamp(shown.a, 0.0, 1.0)));
        },
        256);
    return colors;
}

void check_vertex_colors(const std::string& out, const RecipeOptions& recipe) {
    if (!holds_colors(out) || is_materialx(out))
        throw Error(ExitCode::usage,
                    fmt::format("{}: --vertex-colors: only .glb, .gltf, .obj and .ply hold points "
                                "with colours",
                                out));
    for (const RecipeEdit& edit : recipe.edits())
        if (edit.path.starts_with("atlas."))
            throw Error(ExitCode::usage,
                        fmt::format("{} does nothing: --vertex-colors writes no texture; leave one "
                                    "of the two out",
                                    edit.said));
}

std::vector<std::string> lost_with_vertex_colors(const Recipe& recipe, const std::string& out) {
    const MaterialAsked separate{Packing::separate, 8, 0, false, 0.0};
    std::vector<std::string> lost = picture_names({&recipe, 1}, separate);
    if (is_obj(out) && is_transparent(recipe)) lost.emplace_back("opacity");
    if (!recipe.bump.empty()) lost.emplace_back("bumps");
    if (!recipe.paint.empty()) lost.emplace_back("paint");
    return lost;
}

BakeResult bake_vertex_colors(Pipeline& pipeline, const BakePlan& plan, const MeshPose* pose) {
    BakeResult result;
    const Recipe recipe = plan.recipe(0);
    const Mesh& mesh = pipeline.mesh();
    ExportOptions options;
    options.crease_degrees = plan.crease_degrees;
    options.recipe_json = to_json(recipe);
    options.recipe_name = recipe.name;
    options.material = material_factors(recipe);
    options.obj = plan.obj;
    options.tell = [&](const std::string& what) {
        if (plan.tell) plan.tell(fmt::format("{}: {}", mesh.name, what));
    };
    if (pose) options.pose = ExportPose{*pose, recipe.pose.weight};
    const std::string shader = shader_text(plan, mesh, recipe);
    options.vertex_colors = vertex_colors(recipe, mesh);
    if (plan.strips) options.strips = &result.strips;
    const auto writing = std::chrono::steady_clock::now();
    std::vector<AtomicFile> files = scene_files(plan.paths.front(), mesh, {}, {}, options);
    if (!shader.empty()) files.emplace_back(plan.shader).write(shader);
    result.committed = commit_together(files);
    result.writing = seconds_since(writing);
    return result;
}

}  // namespace burl
