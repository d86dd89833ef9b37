#include "app/bake/bake.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "app/bake/expected_tasks.h"
#include "app/bake/texture.h"
#include "app/bake/tiles.h"
#include "app/base/stopwatch.h"
#include "app/export/emit.h"
#include "app/export/formats.h"
#include "app/pipeline/displaced_mesh.h"
#include "app/pipeline/mask_picture.h"
#include "app/pipeline/tasks.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/lattice_check.h"
#include "atlas/base/error.h"
#include "atlas/base/memory.h"
#include "atlas/build/capacity.h"
#include "atlas/build/mesh_atlas.h"

namespace burl {

namespace {

using Clock = std::chrono::steady_clock;

void tell(const BakePlan& plan, const Mesh& mesh, const std::string& what) {
    if (!what.empty() && plan.tell) plan.tell(fmt::format("{}: {}", mesh.name, what));
}

/// Warns of triangles that get too few texels: before the layout, but for strips after it, which
/// may not hold the mesh at all; then the error alone is told.
void tell_shortage(const BakePlan& plan, const Mesh& mesh, const AtlasOptions& atlas,
                   const MeshAtlas* made) {
    if (is_strips(atlas.kind) == (made != nullptr))
        tell(plan, mesh, shortage(capacity(mesh.triangles.size(), atlas)));
}

/// Tells what comes next. Throws Error where the bake is to stop.
void go_on(const BakePlan& plan, const char* next) {
    if (plan.stop.stop_requested())
        throw Error(ExitCode::runtime, "the export was stopped before it was done");
    if (plan.told) plan.told->meter().begin(next);
}

void set_frame(Pipeline& pipeline, const BakePlan& plan, std::size_t number) {
    const Recipe recipe = plan.recipe(number);
    check_lattice(recipe, pipeline.mesh());
    pipeline.set_recipe(recipe);
}

/// The size of an arena for the plan's threads; more than there are would be warned of.
int threads_of(const BakePlan& plan) {
    const auto most =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    return plan.threads > 0 ? std::min(plan.threads, int(most)) : tbb::task_arena::automatic;
}

/// The recipe of a shared atlas as its document's material needs it.
ExportShare export_share(const Recipe& recipe, const BakePlan& plan, const MaterialAsked& asked,
                         const std::vector<ExportPicture>& pictures) {
    ExportShare share{recipe.name, to_json(recipe), material_factors(recipe, asked.rough_levels()),
                      is_transparent(recipe),
                      plan.normals != NormalSpace::none && !recipe.bump.empty()};
    share.slots.resize(pictures.size());
    for (MaterialPicture& one : material_pictures(recipe, plan.packing, asked.rough_levels())) {
        const auto at = std::ranges::find(pictures, one.name, &ExportPicture::name);
        share.slots[std::size_t(at - pictures.begin())] = std::move(one.slots);
    }
    return share;
}

ExportOptions export_options(Pipeline& pipeline, const BakePlan& plan, const MeshPose* pose) {
    ExportOptions options;
    options.crease_degrees = plan.crease_degrees;
    options.recipe_json = to_json(pipeline.recipe());
    options.recipe_name = pipeline.recipe().name;
    options.obj = plan.obj;
    options.tell = [&](const std::string& what) { tell(plan, pipeline.mesh(), what); };
    if (pose)
        options.pose = ExportPose{atlas_pose(*pose, pipeline.mesh(), pipeline.mesh_atlas()),
                                  pipeline.recipe().pose.weight};
    options.pose_keys = plan.pose_keys;
    return options;
}

std::optional<NormalMap> bake_normals(Pipeline& pipeline, const BakePlan& plan,
                                      const BakedMaterial& material) {
    auto map = bake_normals(pipeline, plan.normals, plan.depth, plan.crease_degrees, plan.sharing);
    if (map) add_levels(*map, material.normal_levels);
    if (map && plan.normals_down) turn_green(*map);
    return map;
}

/// Writes the normal map beside an .exr, if there is one.
std::vector<AtomicFile> normals_beside(const BakePlan& plan, const std::string& path,
                                       const std::optional<NormalMap>& normals) {
    std::vector<AtomicFile> files;
    if (normals)
        encode_normals(*normals, plan.coding,
                       sink_of(files.emplace_back(normal_map_path(path, plan.coding.format))));
    return files;
}

/// Writes the files of an .exr band by band; the whole texture is never in memory.
std::vector<AtomicFile> files_in_bands(Pipeline& pipeline, const BakePlan& plan,
                                       const std::string& path, BakeResult& result) {
    result.normals = bake_normals(pipeline, plan, {});
    std::vector<AtomicFile> files = normals_beside(plan, path, result.normals);
    BandsWritten bands = write_exr_in_bands(pipeline, path, plan.levels, plan.exr_depth);
    result.levels.count = std::uint32_t(bands.levels);
    result.writing += bands.seconds;
    files.push_back(std::move(bands.file));
    return files;
}

/// Writes a material as .exr, with a layer per channel.
std::vector<AtomicFile> files_of_material(Pipeline& pipeline, const BakePlan& plan,
                                          const std::string& path, const MaterialAsked& asked,
                                          BakeResult& result) {
    MaterialAsked pictures = asked;
    pictures.normals =
        false;  // normals beside an .exr have no levels that roughness could make up for
    result.normals = bake_normals(pipeline, plan, {});
    std::vector<AtomicFile> files = normals_beside(plan, path, result.normals);
    files.push_back(write_material_exr(pipeline, path, pictures, plan.exr_depth));
    result.levels.count = asked.levels;
    return files;
}

/// Carves the document that the mesh was read from.
std::vector<AtomicFile> files_of_kept(Pipeline& pipeline, KeptScene& kept,
                                      const SceneContent& content) {
    return kept_files(kept, content, corner_origins(pipeline.mesh(), pipeline.mesh_atlas()));
}

/// Writes the files of the frame `number`, which are still to be committed. If `releases`, the
/// solid points are freed before the files are written, whose buffers are as large.
std::vector<AtomicFile> files_of_frame(Pipeline& pipeline, const BakePlan& plan, std::size_t number,
                                       const MeshPose* pose, bool releases, BakeResult& result) {
    const std::string& path = plan.paths[number];
    const ImageKind kind = plan.kind;
    MaterialAsked asked = plan.material();
    const bool pictures = !plan.sharing.empty() ||
                          has_pictures(pipeline.recipe(), plan.packing, asked.rough_levels());
    if (pictures) asked.levels = levels_there_are(pipeline, plan.levels, kind).count;
    if (kind == ImageKind::rgb_float && pictures)
        return files_of_material(pipeline, plan, path, asked, result);
    if (kind == ImageKind::rgb_float && !plan.compress && comes_in_bands(pipeline, plan.levels))
        return files_in_bands(pipeline, plan, path, result);
    BakedMaterial material;
    if (pictures) material = bake_material(pipeline, asked, plan.sharing);
    BakedTexture texture =
        pictures ? BakedTexture{std::move(material.color), std::move(material.color_levels)}
                 : bake_texture(pipeline, kind, plan.levels);
    result.texture = compressed_bake(pipeline.atlas(), std::move(texture.image), plan.compress);
    if (plan.normals != NormalSpace::none) go_on(plan, tasks::normals);
    std::optional<NormalMap> normals = bake_normals(pipeline, plan, material);
    go_on(plan, tasks::pictures);
    if (releases) pipeline.release_texels();
    const auto writing = Clock::now();
    ExportOptions options = export_options(pipeline, plan, pose);
    if (plan.strips) options.strips = &result.strips;
    options.levels = std::move(texture.levels);
    options.normals = std::move(normals);
    options.material = material_factors(pipeline.recipe(), asked.rough_levels());
    options.pictures = std::move(material.pictures);
    for (const Recipe& recipe : plan.sharing) {
        if (&recipe != &plan.sharing.front()) options.recipe_name += '+' + recipe.name;
        options.shares.push_back(export_share(recipe, plan, asked, options.pictures));
    }
    cut_to_extent(pipeline.atlas().options, result.texture.image, options);
    options.coding = plan.coding;
    options.coding.meter = plan.meter();
    options.exr_depth = plan.exr_depth;
    const BakedAtlas& baked = result.texture;
    const Atlas& atlas = baked.packed ? *baked.packed : pipeline.atlas();
    const Mesh& rest = pipeline.atlas_mesh();
    tbb::task_arena arena(threads_of(plan));
    std::vector<AtomicFile> files = arena.execute([&] {
        if (plan.kept)
            return files_of_kept(pipeline, *plan.kept, {path, rest, atlas, baked.image, options});
        if (!plan.displaces) return scene_files(path, rest, atlas, baked.image, options);
        return scene_files(path, displaced_mesh(rest, pipeline.recipe(), pipeline.mesh()), atlas,
                           baked.image, options);
    });
    if (plan.kept) result.lost = plan.kept->document.losses;
    result.levels.count = std::uint32_t(options.levels.size());
    result.normals = std::move(options.normals);
    result.writing += seconds_since(writing);
    return files;
}

template <class Code>
void write_mask(AtomicFile& file, Pipeline& pipeline, const std::string& name,
                const PictureCoding& coding) {
    if (name == light_picture_name)
        encode_picture(light_picture<Rgb<Code>>(pipeline), sink_of(file), coding);
    else
        encode_picture(mask_picture<Code>(pipeline, name), sink_of(file), coding);
}

/// Adds a picture of each mask that the plan has.
void add_channels(std::vector<AtomicFile>& files, Pipeline& pipeline, const BakePlan& plan) {
    for (const std::string& name : plan.channels) {
        AtomicFile& file =
            files.emplace_back(picture_path(plan.paths.front(), name, plan.coding.format));
        if (plan.depth == 16)
            write_mask<Grey16>(file, pipeline, name, plan.coding);
        else
            write_mask<Grey8>(file, pipeline, name, plan.coding);
    }
}

/// Adds the shader, the masks and the solid map where the plan has them.
void add_beside(std::vector<AtomicFile>& files, Pipeline& pipeline, const BakePlan& plan,
                const std::string& shader, BakeResult& result) {
    if (!plan.shader.empty()) files.emplace_back(plan.shader).write(shader);
    add_channels(files, pipeline, plan);
    if (plan.solid_map.empty()) return;
    auto [base, file] = write_solid_map(plan.solid_map, pipeline, plan.threads);
    files.push_back(std::move(file));
    result.solid_base = base;
}

void commit(std::vector<AtomicFile>& files, BakeResult& result) {
    const auto naming = Clock::now();
    std::ranges::move(commit_together(files), std::back_inserter(result.committed));
    result.writing += seconds_since(naming);
}

}  // namespace

std::vector<std::string> uv_losses(const Mesh& mesh, const LayoutNotes& notes) {
    std::vector<std::string> losses;
    if (notes.overlapped_texels > 0)
        losses.push_back(fmt::format("{} triangles share {} texels, which show the first of them",
                                     notes.overlapping_triangles, notes.overlapped_texels));
    if (notes.flat_triangles > 0)
        losses.push_back(
            fmt::format("{} of {} triangles have no texture coordinates, or no area in them, and "
                        "show what is at their corners",
                        notes.flat_triangles, mesh.triangles.size()));
    return losses;
}

std::string shader_text(const BakePlan& plan, const Mesh& mesh, const Recipe& recipe) {
    if (plan.shader.empty()) return "";
    const EmittedShader shader = emit_glsl(recipe, solid_from_mesh(mesh, recipe.solid.space));
    for (const std::string& note : shader.notes) tell(plan, mesh, note);
    return shader.text;
}

BakeResult bake(Pipeline& pipeline, const BakePlan& plan, const MeshPose* pose, LaterBake later) {
    BakeResult result;
    result.levels.rule = plan.levels.rule;
    result.paths = plan.paths;
    const Mesh& mesh = pipeline.mesh();
    set_frame(pipeline, plan, 0);
    const Recipe& recipe = pipeline.recipe();
    const std::string shader = shader_text(plan, mesh, recipe);

    StageContext& context = pipeline.context();
    Stages& stages = pipeline.stages();
    context.stop = plan.stop, context.meter = plan.meter();
    if (plan.told) {
        plan.told->meter().begin_round(0, plan.paths.size());
        plan.told->expect(expected_tasks(plan, recipe, pipeline));
    }
    tell_shortage(plan, mesh, recipe.atlas, nullptr);
    go_on(plan, tasks::layout);
    const Connectivity& edges = pipeline.connectivity();
    const MeshAtlas* made = stages.layout.run(context, mesh, edges, recipe.atlas, plan.stop);
    go_on(plan, tasks::points);
    const MeshAtlas& atlas = *made;
    tell(plan, mesh, atlas.atlas().notes.fallback);
    result.tile_notes = plan.tile_notes;
    for (const std::string& loss : uv_losses(mesh, plan.tile_notes.value_or(atlas.atlas().notes)))
        tell(plan, mesh, loss);
    tell_shortage(plan, mesh, recipe.atlas, &atlas);
    if (later == LaterBake::none) stages.connectivity.release_neighbours();
    const SolidAtlas& points = pipeline.solid();
    if (plan.measures) result.metrics = measure(atlas.mesh(mesh), atlas.atlas(), points);
    if (mesh.triangles.size() > many_triangles) return_freed_memory();

    const bool needed_later = later == LaterBake::atlas || !plan.solid_map.empty() ||
                              !plan.channels.empty() || plan.normals != NormalSpace::none;
    for (std::size_t i = 0; i < plan.paths.size(); ++i) {
        const bool last = i + 1 == plan.paths.size();
        if (i > 0) set_frame(pipeline, plan, i);
        if (i > 0 && plan.told) plan.told->meter().begin_round(i, plan.paths.size());
        result.texture = {};  // frees the last frame's texture before the next is made
        result.normals.reset();
        go_on(plan, tasks::texture);
        std::vector<AtomicFile> files =
            files_of_frame(pipeline, plan, i, pose, last && !needed_later, result);
        go_on(plan, tasks::write);
        if (last) add_beside(files, pipeline, plan, shader, result);
        go_on(plan, tasks::write);
        commit(files, result);
    }
    return result;
}

}  // namespace burl
