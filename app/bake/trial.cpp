#include "app/bake/trial.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <ctime>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "app/bake/material.h"
#include "app/base/stopwatch.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

constexpr std::uint32_t squares_a_side = 4, square_count = squares_a_side * squares_a_side;
/// Sides of a trial's texture in texels; small ones say little of how long encoding takes.
constexpr std::uint32_t least_trial = 256, most_trial = 512;
/// The bake's texels a thread for each of the trial's.
constexpr double texels_a_trial = 64.0;

/// Two directions along triangle t of the mesh, at right angles and of length 1.
std::pair<Vec3d, Vec3d> directions_of(const Mesh& mesh, std::size_t t) {
    const Triangle& corners = mesh.triangles[t];
    const Vec3d u = mesh.positions[corners[1]] - mesh.positions[corners[0]];
    const Vec3d across = glm::cross(u, mesh.positions[corners[2]] - mesh.positions[corners[0]]);
    if (!(glm::dot(across, across) > 0.0)) return {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    return {glm::normalize(u), glm::normalize(glm::cross(across, u))};
}

/// Adds a square of a side from triangle t's first corner on, in solid space.
void add_square(const Mesh& mesh, std::size_t t, const Affine3& map, double side, Mesh& out) {
    const auto [u, v] = directions_of(mesh, t);
    const Vec3d low = map(mesh.positions[mesh.triangles[t][0]]);
    const auto first = std::uint32_t(out.positions.size());
    for (const Vec3d& corner : {low, low + side * u, low + side * (u + v), low + side * v})
        out.positions.push_back(corner);
    out.triangles.push_back({first, first + 1, first + 2});
    out.triangles.push_back({first, first + 2, first + 3});
    out.source_faces.insert(out.source_faces.end(), 2, first / 4);
}

/// Squares whose texels are as large as those of the recipe's texture of the mesh, in solid space;
/// without triangles if the mesh has no area. `size` is the side of the squares' texture in texels.
Mesh squares_at(const Mesh& mesh, const Recipe& recipe, std::uint32_t size) {
    const Affine3 map = solid_from_mesh(mesh, recipe.solid.space);
    double area = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area += triangle_area(mesh, t);
    const double texels = double(recipe.atlas.columns()) * double(recipe.atlas.rows());
    const double scale = glm::length(map.linear[0]);
    const double texel = scale * std::sqrt(area / (usual_coverage * texels));
    Mesh out;
    out.name = mesh.name;
    if (!(texel > 0.0) || !std::isfinite(texel)) return out;
    for (std::size_t i = 0; i < square_count; ++i)
        add_square(mesh, i * mesh.triangles.size() / square_count, map,
                   texel * double(size / squares_a_side), out);
    out.parts.push_back({out.name, 0, std::uint32_t(out.triangles.size())});
    return out;
}

/// Seconds that the thread has had of a processor: other programs do not count.
double thread_seconds() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Encodes a picture of a trial as one of the bake.
template <class Picture>
void encode(const Picture& picture, const PictureCoding& coding) {
    const auto nowhere = [](std::span<const std::uint8_t>) {};
    std::visit(
        [&]<class Pixel>(const Image<Pixel>& image) {
            if constexpr (!std::is_same_v<Pixel, RgbF> && !std::is_same_v<Pixel, RgbaF>)
                encode_picture(image, nowhere, coding);
        },
        picture);
}

/// The material of a bake, without its normal map.
BakedMaterial material_of(Pipeline& pipeline, const BakePlan& plan) {
    MaterialAsked asked = plan.material();
    const auto finest = std::uint32_t(std::bit_width(pipeline.recipe().atlas.size)) - 1;
    asked.levels = std::min(asked.levels, finest);
    if (has_pictures(pipeline.recipe(), plan.packing, asked.rough_levels()))
        return bake_material(pipeline, asked);
    BakedMaterial material;
    material.color = bake_texture(pipeline, plan.kind, {asked.levels, plan.levels.rule}).image;
    return material;
}

/// The costs of a whole trial by one thread, rather than of a texel.
TrialCosts costs_of(Mesh squares, const StageContext& context, const Recipe& recipe,
                    const BakePlan& plan) {
    Pipeline pipeline(std::move(squares));
    pipeline.context().way = context.way;
    pipeline.context().way.threads = 1;
    pipeline.context().skips = context.skips;
    pipeline.set_recipe(recipe);
    pipeline.solid();
    TrialCosts costs;
    const auto begun = std::chrono::steady_clock::now();
    const double start = thread_seconds();
    const BakedMaterial material = material_of(pipeline, plan);
    const double whole = seconds_since(begun);
    const double made = thread_seconds();
    const auto normals = bake_normals(pipeline, plan.normals, plan.depth, plan.crease_degrees);
    const double turned = thread_seconds();
    const auto try_encoding = [&](const auto& picture) {
        const double begins = thread_seconds();
        encode(picture, plan.coding);
        costs.pictures.push_back(thread_seconds() - begins);
    };
    try_encoding(material.color);
    if (normals) try_encoding(normals->image);
    for (const ExportPicture& picture : material.pictures) try_encoding(picture.image);
    costs.normals = normals ? turned - made : 0.0;
    const StageRecords& records = pipeline.records();
    costs.normal_maps = records[Stage::normals].runs;
    // The material's MIP levels have had a normal map, too.
    const bool twice = costs.normal_maps > 1;
    const double rest = std::max(0.0, made - start - (twice ? costs.normals : 0.0));
    const double rest_whole = whole - (twice ? records[Stage::normals].seconds / 2.0 : 0.0);
    costs.texture = rest;
    if (plan.levels.count > 0 && rest_whole > 0.0) {
        const double of_levels = records[Stage::levels].seconds / rest_whole;
        const double of_texture = records[Stage::synthesis].seconds / rest_whole;
        // A texture alone is halved in bands as it is made; a material's levels come after it.
        costs.texture *=
            std::clamp(material.pictures.empty() ? 1.0 - of_levels : of_texture, 0.0, 1.0);
    }
    costs.levels = rest - costs.texture;
    return costs;
}

/// The costs of a texel by one thread, of trials of `size` texels a side and of a quarter of that:
/// what does not grow with the number of texels is the same in both.
TrialCosts costs_of_texel(Pipeline& pipeline, const Recipe& recipe, const BakePlan& plan,
                          std::uint32_t size) {
    const auto costs = [&](std::uint32_t side) {
        Mesh mesh = squares_at(pipeline.mesh(), recipe, side);
        Recipe small = recipe;
        small.atlas = {.kind = AtlasKind::quad, .size = side};
        small.solid.space = SolidSpace::object;
        return mesh.triangles.empty() ? TrialCosts()
                                      : costs_of(std::move(mesh), pipeline.context(), small, plan);
    };
    const TrialCosts few = costs(size / 4), all = costs(size);
    const double texels = double(size) * double(size);
    const auto each = [&](double TrialCosts::*cost) {
        return std::max((all.*cost - few.*cost) / 0.9375, 0.5 * all.*cost) / texels;
    };
    // A picture's encoding tries filters on a share of it, at the least on so many bytes.
    TrialCosts result{each(&TrialCosts::texture), each(&TrialCosts::levels),
                      each(&TrialCosts::normals), all.pictures, all.normal_maps};
    for (double& picture : result.pictures) picture /= texels;
    return result;
}

}  // namespace

double threads_at_work(const BakePlan& plan) {
    const auto all =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    return double(plan.threads > 0 ? std::size_t(plan.threads) : all);
}

TrialCosts try_costs(Pipeline& pipeline, const Recipe& recipe, const BakePlan& plan) {
    const double threads = threads_at_work(plan);
    const double texels = double(recipe.atlas.columns()) * double(recipe.atlas.rows());
    const auto side = std::uint32_t(std::sqrt(texels / (texels_a_trial * threads)));
    if (side < least_trial) return {};
    const std::uint32_t size = std::min(std::bit_floor(side), most_trial);
    TrialCosts costs;
    try {
        tbb::task_arena one(1);
        one.execute([&] { costs = costs_of_texel(pipeline, recipe, plan, size); });
    } catch (const Error&) {
        return {};  // the bake itself says what is wrong
    }
    for (double* cost : {&costs.texture, &costs.levels, &costs.normals}) *cost /= threads;
    for (double& picture : costs.pictures) {
        if (plan.coding.format == TextureFormat::png) picture /= threads;
        if (plan.levels.count > 0) picture *= 4.0 / 3.0;
    }
    return costs;
}

}  // namespace burl
