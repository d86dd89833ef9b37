#include "app/measure/measuring.h"

#include <bit>
#include <utility>

#include <fmt/format.h>

#include "app/image/image_io.h"
#include "app/pipeline/tasks.h"
#include "app/recipe/recipe_cost.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "atlas/base/stop.h"
#include "atlas/measure/uv_atlas.h"

namespace burl {

std::vector<AtlasKind> all_atlas_kinds(std::uint32_t size) {
    std::vector<AtlasKind> kinds{AtlasKind::uniform, AtlasKind::area, AtlasKind::length};
    if (std::has_single_bit(size)) kinds.push_back(AtlasKind::quad);
    kinds.push_back(AtlasKind::patch);
    kinds.push_back(AtlasKind::chart);
    return kinds;
}

void check_square(const AtlasOptions& atlas) {
    if (atlas.columns() != atlas.rows())
        throw Error(ExitCode::unsupported,
                    fmt::format("metrics measures square textures; use --size {}", atlas.size));
}

std::string measured_name(AtlasKind kind) {
    return kind == AtlasKind::uv ? "uv-atlas" : std::string(to_string(kind));
}

std::string measured_picture(const std::string& prefix, std::string_view atlas, const char* topic) {
    return fmt::format("{}-{}-{}.png", prefix, atlas, topic);
}

namespace {

/// The colour at points, of which each call looks whether it is to stop: the loops that ask for it
/// pass the exception on.
SolidColor unless_stopped(SolidColor color, const std::stop_token& stop) {
    if (!stop.stop_possible()) return color;
    return [color = std::move(color), stop](const Vec3d& point) {
        check_stop(stop);
        return color(point);
    };
}

TruthOptions truth_options(const Recipe& recipe, double detail) {
    TruthOptions options;
    options.size = recipe.atlas.size;
    options.detail = detail;
    options.view_points = view_points;
    return options;
}

}  // namespace

double noises_of_measuring(const MeasuringPlan& plan, const Mesh& mesh, bool own_uvs,
                           std::size_t kinds) {
    if (!plan.looks_up_recipe || (!plan.lookups && plan.image.empty())) return 0.0;
    const double point = noises_per_point(plan.recipe, false), side = plan.recipe.atlas.size;
    const double filled = double(kinds + (own_uvs ? 1 : 0)) * side * side * point;
    if (!plan.lookups) return filled;
    const TruthOptions options =
        truth_options(plan.recipe, recipe_texture(plan.recipe, mesh).detail);
    // A texture with direct levels, whose samples are a third of its texels.
    const double direct = 4.0 / 3.0 * double(kinds) * noises_of_texture(plan.recipe, false);
    return filled + direct + point * truth_calls(normalised(mesh), options);
}

Measuring::Measuring(MeasuringPlan plan, Mesh measured_mesh)
    : plan_(std::move(plan)),
      pipeline_(std::move(measured_mesh)),
      edges_(mesh_edges(mesh(), pipeline_.connectivity())),
      texture_(plan_.looks_up_recipe ? recipe_texture(plan_.recipe, mesh())
                                     : metric_marble_texture()) {
    texture_.color = unless_stopped(texture_.color, plan_.stop);
    if (!plan_.lookups) return;
    go_on("sampling the surface");
    truth_ = surface_truth(normalised(mesh()), texture_.color,
                           truth_options(plan_.recipe, texture_.detail));
}

MeasuredAtlas Measuring::our_atlas(AtlasKind kind) {
    plan_.recipe.atlas.kind = kind;
    pipeline_.set_recipe(plan_.recipe);
    pipeline_.context().stop = plan_.stop;
    go_on(tasks::layout);
    pipeline_.lay_out(plan_.stop);
    check_stop(plan_.stop);
    const MeshAtlas& atlas = pipeline_.mesh_atlas();
    const auto points_of = [&](const Mesh& surface, const Atlas&, const auto& positions) {
        return rasterize(surface, atlas, positions);
    };
    const std::string name = measured_name(kind);
    if (!atlas.patches())
        return with_direct(measured(name, mesh(), edges_, atlas.atlas(), truth_, points_of),
                           truth_);
    const Mesh& refined = pipeline_.atlas_mesh();
    const std::optional<SurfaceTruth> truth = refined_truth(atlas);
    return with_direct(measured(name, refined, mesh_edges(refined, build_connectivity(refined)),
                                atlas.atlas(), truth, points_of),
                       truth);
}

MeasuredAtlas Measuring::uv_atlas() {
    return measured("uv", mesh(), edges_,
                    atlas_from_uvs(mesh(), pipeline_.connectivity(), plan_.recipe.atlas.size),
                    truth_, rasterize_uvs);
}

Json Measuring::json(const std::vector<MeasuredAtlas>& atlases) {
    Json rows = Json::array();
    for (const MeasuredAtlas& atlas : atlases) rows.push_back(measured_json(atlas));
    return {{"mesh", mesh_json(mesh(), pipeline_.connectivity())}, {"atlases", rows}};
}

/// Tells what comes next. Throws Error(runtime) where the measuring is to stop.
void Measuring::go_on(const char* task) const {
    check_stop(plan_.stop);
    if (plan_.meter) plan_.meter->begin(task);
}

std::vector<MeasuredAtlas> Measuring::all(bool own_uvs, std::span<const AtlasKind> kinds) {
    const std::size_t count = kinds.size() + (own_uvs ? 1 : 0);
    std::vector<MeasuredAtlas> atlases;
    const auto begin = [&] {
        if (plan_.meter) plan_.meter->begin_round(atlases.size(), count);
    };
    if (own_uvs) {
        begin();
        atlases.push_back(uv_atlas());
    }
    for (const AtlasKind kind : kinds) {
        begin();
        atlases.push_back(our_atlas(kind));
    }
    return atlases;
}

/// Adds the errors of levels synthesised directly, which only a recipe's texture has.
MeasuredAtlas Measuring::with_direct(MeasuredAtlas result,
                                     const std::optional<SurfaceTruth>& truth) {
    if (!truth || texture_.name == metric_marble_name) return result;
    const Image<RgbF> texture = pipeline_.synthesize<RgbF>();
    const auto count = std::uint32_t(truth->levels.size());
    result.direct =
        level_errors(pipeline_.atlas(), pipeline_.levels(texture, count, {.direct = true}), *truth);
    return result;
}

std::optional<SurfaceTruth> Measuring::refined_truth(const MeshAtlas& atlas) const {
    std::optional<SurfaceTruth> truth = truth_;
    if (!truth) return truth;
    truth->points = refined_points(mesh(), atlas, std::move(truth->points));
    truth->level_points = refined_points(mesh(), atlas, std::move(truth->level_points));
    truth->grazing.points = refined_points(mesh(), atlas, std::move(truth->grazing.points));
    truth->views.points = refined_points(mesh(), atlas, std::move(truth->views.points));
    return truth;
}

/// Measures an atlas; `surface` is the mesh whose triangles the atlas places, and the truth's
/// points lie on it.
template <class Rasterize>
MeasuredAtlas Measuring::measured(std::string name, const Mesh& surface,
                                  const std::vector<MeshEdge>& edges, const Atlas& atlas,
                                  const std::optional<SurfaceTruth>& truth,
                                  Rasterize&& points_of) const {
    go_on("measuring the atlas");
    const SolidAtlas solid = points_of(surface, atlas, surface.positions);
    MeasuredAtlas result{std::move(name), atlas,        measure_atlas(surface, atlas, solid, edges),
                         texture_.name,   std::nullopt, {}};
    if (!truth && plan_.image.empty()) return result;
    go_on("measuring lookups");
    const Mesh unit = normalised(surface);
    const TextureValues values =
        fill_texture(points_of(unit, atlas, unit.positions), texture_.color, plan_.fill);
    check_stop(plan_.stop);
    if (truth)
        result.lookups =
            measure_lookups(unit, atlas, values, edges, *truth, in_8bit_srgb(), plan_.sharp);
    if (!plan_.image.empty())
        draw({surface, atlas, solid, plan_.view}, measure_charts(surface, atlas, edges), values,
             result);
    return result;
}

void Measuring::draw(const PicturedAtlas& what, const ChartMetrics& charts,
                     const TextureValues& values, MeasuredAtlas& measured) const {
    const auto write = [&](const char* topic, const Image<Rgb8>& picture) {
        measured.images.push_back(measured_picture(plan_.image, measured.name, topic));
        write_png(measured.images.back(), picture);
    };
    write(picture_topics[0], charts_picture(what, charts.of_triangle));
    write(picture_topics[1], scale_picture(what));
    write(picture_topics[2], levels_picture(what, values, plan_.sharp));
}

}  // namespace burl
