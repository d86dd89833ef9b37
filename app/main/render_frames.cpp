#include "app/main/render_frames.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "app/base/messages.h"
#include "app/base/progress.h"
#include "app/gl/device/context.h"
#include "app/gl/draw/lazy_picture.h"
#include "app/gl/draw/render.h"
#include "app/image/sheet.h"
#include "app/measure/report.h"
#include "app/options/idle_options.h"
#include "app/options/input_limits.h"
#include "app/options/metres.h"
#include "app/pipeline/material.h"
#include "app/recipe/lattice_check.h"
#include "app/recipe/presets.h"
#include "app/recipe/recipe_cost.h"
#include "app/scene/scene.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

TextureFilter parse_lookup(const std::string& text) {
    if (text == "nearest") return TextureFilter::nearest;
    if (text == "linear") return TextureFilter::linear;
    if (text == "mip") return TextureFilter::mip;
    throw Error(ExitCode::usage,
                fmt::format("--filter {}: it must be nearest, linear or mip; filters of the "
                            "texture itself are --direct's, or --set filter.kind=... of --lazy",
                            text));
}

std::optional<TextureFilter> lookup_of_options(const DirectOptions& options) {
    if (!options.filter) return std::nullopt;
    return parse_lookup(*options.filter);
}

/// Calls make(), whose errors on a sheet name the cell's recipe.
template <class Make>
auto in_cell(const RenderCommand& command, std::size_t cell, const Make& make) {
    if (!command.is_sheet()) return make();
    try {
        return make();
    } catch (const Error& error) {
        throw Error(error.code(), fmt::format("{}: {}", command.recipes[cell], error.what()));
    }
}

/// The picture with its alpha where the background is transparent, else without.
Picture shown(Image<Rgba8> picture, const PictureOptions& options) {
    if (options.background.kind == Background::Kind::transparent) return picture;
    return colors_and_alpha(std::move(picture)).first;
}

/// A scene that is uploaded once for all frames.
struct DrawnScene {
    Scene scene;
    std::vector<View> views;
    PictureOptions picture;
    Sphere sphere;
    std::unique_ptr<GlContext> context;
    std::optional<GlSurroundings> around{};
    std::optional<GlScene> uploaded{};

    Picture draw(std::size_t frame) const {
        const Camera camera = orbit_camera(views[frame], sphere, picture.size);
        return shown(render_picture(*context, *uploaded, *around, camera, picture), picture);
    }
};

RenderedFrames scene_frames(const RenderCommand& command, CommandFiles& files) {
    const DirectOptions& options = command.options;
    if (options.scene.empty())
        throw Error(ExitCode::usage, "a scene is missing; --plane alone is for --direct");
    if (is_sample_mesh(options.scene))
        throw Error(ExitCode::usage,
                    fmt::format("{} is a mesh, not a baked scene; add --lazy or --direct, or bake "
                                "it first",
                                options.scene));
    const std::optional<TextureFilter> filter = lookup_of_options(options);
    const auto drawn = std::make_shared<DrawnScene>();
    drawn->views = command.frame_views();
    drawn->picture = options.picture_options();
    const ReadOptions& read = options.meshes.read;
    drawn->scene = load_scene(options.scene, options.pose, read.named, read.most_triangles);
    for (const std::string& note : drawn->scene.notes) warn(note);
    files.read(drawn->scene.files);
    turn(drawn->scene, frame_transform(options.meshes.frame));
    drawn->sphere = bounding_sphere(drawn->scene);
    drawn->context = create_gl_context(command.platform);
    drawn->context->make_current();
    drawn->around.emplace(drawn->context->gl(), drawn->scene, drawn->picture);
    drawn->uploaded.emplace(drawn->context->gl(), drawn->scene, filter);
    if (command.anisotropy > 1 && !drawn->uploaded->has_levels())
        throw Error(ExitCode::usage,
                    fmt::format("--anisotropy is of MIP levels, and {} looks none up; add --filter "
                                "mip",
                                options.filter ? "--filter " + *options.filter : options.scene));
    drawn->uploaded->set_anisotropy(command.anisotropy);
    return {[drawn](std::size_t frame, std::size_t) { return drawn->draw(frame); }};
}

/// A mesh whose recipes are drawn by --lazy.
struct LazyFrames {
    std::unique_ptr<GlContext> context;  ///< outlives the light in `options`
    Pipeline pipeline;
    std::vector<View> views;
    std::vector<std::vector<Recipe>> cells;  ///< per cell the recipes of the frames
    LazyOptions options;
    std::optional<MeshPose> pose{};
    LazyPicture sum{};  ///< work and seconds of all pictures

    Picture draw(std::size_t frame, std::size_t cell) {
        pipeline.set_recipe(cells[cell][frame]);
        LazyPicture drawn = render_lazily(*context, pipeline, views[frame], options);
        add(drawn);
        return shown(std::move(drawn.picture), options.picture);
    }
    void add(const LazyPicture& drawn);
};

void LazyFrames::add(const LazyPicture& drawn) {
    sum.work.tiles += drawn.work.tiles;
    sum.work.texels_read += drawn.work.texels_read;
    sum.work.texels_made += drawn.work.texels_made;
    sum.work.texels_whole += drawn.work.texels_whole;
    sum.work.synthesis.octaves += drawn.work.synthesis.octaves;
    sum.seconds_finding += drawn.seconds_finding;
    sum.seconds_synthesis += drawn.seconds_synthesis;
    sum.seconds_drawing += drawn.seconds_drawing;
}

Json work_json(const LazyPicture& drawn, std::size_t pictures) {
    const ViewWork& work = drawn.work;
    return {{"pictures", pictures},
            {"tiles", work.tiles},
            {"texels_read", work.texels_read},
            {"texels_synthesised", work.texels_made},
            {"texels_whole", work.texels_whole},
            {"octaves", work.synthesis.octaves},
            {"seconds",
             {{"finding", drawn.seconds_finding},
              {"synthesis", drawn.seconds_synthesis},
              {"drawing", drawn.seconds_drawing}}}};
}

LazyOptions lazy_options(const RenderCommand& command) {
    const DirectOptions& options = command.options;
    LazyOptions lazy;
    lazy.picture = options.picture_options();
    lazy.filter = lookup_of_options(options);
    lazy.crease_degrees = options.crease;
    lazy.skips = command.economy.skips();
    lazy.rule = level_rule_named(command.level_rule.value_or("direct"));
    return lazy;
}

/// Throws Error(usage) for --level-rule of a material whose pictures have no levels of their own,
/// and for levels that need texels which the picture does not show.
void check_rule(const RenderCommand& command, const Recipe& recipe) {
    if (command.level_rule && level_rule_named(*command.level_rule).sharp)
        throw Error(ExitCode::usage,
                    "--level-rule sharp: sharp levels need texels that the picture does not show; "
                    "bake with --levels sharp and render that, or leave it out");
    if (command.level_rule && has_pictures(recipe, Packing::gltf))
        throw Error(ExitCode::usage,
                    "--level-rule does nothing: the recipe's material varies in more than colour, "
                    "and its pictures have no MIP levels but OpenGL's averages; leave it out");
}

/// The recipes of a cell's frames, checked for the mesh.
std::vector<Recipe> lazy_recipes(const RenderCommand& command, const DirectOptions& options,
                                 const Mesh& mesh) {
    const std::vector<std::string>& moves = command.animation.keys;
    std::vector<Recipe> frames = frame_recipes(options.recipe, command.animation);
    set_metres(frames, options.recipe, options.meshes.frame, mesh);
    check_edits(options.recipe, frames.front(), moves);
    check_rule(command, frames.front());
    if (options.pose.empty()) refuse_edits(options.recipe, {&idle_pose, 1}, moves);
    for (const Recipe& recipe : frames) check_lattice(recipe, mesh);
    return frames;
}

/// The light of all pictures.
std::shared_ptr<const GlLight> shared_light(GlContext& context, PictureOptions options) {
    options.ground = false, options.background = {};
    context.make_current();
    return GlSurroundings(context.gl(), Scene{}, options).light();
}

RenderedFrames lazy_frames(const RenderCommand& command, CommandFiles& files) {
    const DirectOptions& options = command.options;
    if (options.scene.empty()) throw Error(ExitCode::usage, "--lazy: a mesh is missing");
    const auto lazy =
        std::make_shared<LazyFrames>(LazyFrames{nullptr,
                                                Pipeline(options.meshes.load(options.scene)),
                                                command.frame_views(),
                                                {},
                                                lazy_options(command)});
    RenderedFrames result{
        [lazy](std::size_t frame, std::size_t cell) { return lazy->draw(frame, cell); }};
    double noises = 0.0;
    for (std::size_t i = 0; i < command.cells(); ++i)
        in_cell(command, i, [&] {
            const DirectOptions cell = command.cell(i);
            std::vector<Recipe> recipes = lazy_recipes(command, cell, lazy->pipeline.mesh());
            files.read(files_of_recipe(cell.recipe.recipe, recipes.front()));
            for (const Recipe& recipe : recipes) noises += noises_of_texture(recipe, true);
            lazy->cells.push_back(std::move(recipes));
        });
    check_noises(command.out, noises, options.recipe);
    if (!options.pose.empty()) {
        lazy->pose = options.meshes.pose(options.scene, options.pose);
        lazy->options.pose = &*lazy->pose;
    }
    lazy->context = create_gl_context(command.platform);
    lazy->options.light = shared_light(*lazy->context, lazy->options.picture);
    if (!command.report.empty())
        result.write_report = [lazy, path = command.report] {
            write_json(path, work_json(lazy->sum, lazy->cells.size() * lazy->views.size()));
        };
    return result;
}

/// Meshes and planes that are drawn by --direct.
struct DirectFrames {
    DirectPicture picture;
    PictureOptions options;
    std::vector<View> views;
    std::vector<std::vector<PictureRecipes>> cells{};  ///< per cell the recipes of the frames

    Picture draw(std::size_t frame, std::size_t cell) {
        picture.look(views[frame]);
        return shown(picture.with_alpha(cells[cell][frame]), options);
    }
};

/// The files of the recipes that a picture shows.
void read_recipes(const DirectOptions& options, const PictureRecipes& recipes,
                  CommandFiles& files) {
    files.read(files_of_recipe(options.recipe.recipe, recipes.main));
    for (std::size_t k = 0; k < options.planes.size(); ++k)
        if (const std::optional<Recipe>& recipe = recipes.planes[k])
            files.read(files_of_recipe(parse_plane(options.planes[k]).recipe, *recipe));
}

/// The noises of a cell's pictures: every sample shows the recipe that takes most of them.
double noises_of_pictures(const DirectOptions& options, std::span<const PictureRecipes> frames) {
    const PictureOptions picture = options.picture_options();
    const double samples = double(picture.size.width) * double(picture.size.height) *
                           std::pow(double(picture.supersample), 2);
    double sum = 0.0;
    for (const PictureRecipes& recipes : frames) {
        double most = options.scene.empty() ? 0.0 : noises_per_point(recipes.main, true);
        for (const std::optional<Recipe>& plane : recipes.planes)
            most = std::max(most, noises_per_point(plane ? *plane : recipes.main, true));
        sum += samples * most;
    }
    return sum;
}

RenderedFrames direct_frames(const RenderCommand& command, CommandFiles& files) {
    std::vector<std::vector<PictureRecipes>> cells;
    RenderedFrames result;
    double noises = 0.0;
    for (std::size_t i = 0; i < command.cells(); ++i)
        in_cell(command, i, [&] {
            const DirectOptions cell = command.cell(i);
            cells.push_back(picture_recipes(cell, command.animation));
            read_recipes(cell, cells.back().front(), files);
            noises += noises_of_pictures(cell, cells.back());
        });
    check_noises(command.out, noises, command.options.recipe);
    const auto direct = std::make_shared<DirectFrames>(
        DirectFrames{DirectPicture(command.options), command.options.picture_options(),
                     command.frame_views(), std::move(cells)});
    for (std::size_t i = 0; i < direct->cells.size(); ++i)
        for (PictureRecipes& recipes : direct->cells[i])
            set_metres({&recipes.main, 1}, command.cell(i).recipe, command.options.meshes.frame,
                       direct->picture.mesh());
    result.draw = [direct](std::size_t frame, std::size_t cell) {
        return direct->draw(frame, cell);
    };
    return result;
}

/// The names below the cells: as they are typed, of files without folder and extension.
std::vector<std::string> sheet_names(const RenderCommand& command) {
    std::vector<std::string> names;
    for (const std::string& recipe : command.recipes)
        names.push_back(names_preset(recipe) ? recipe
                                             : std::filesystem::path(recipe).stem().string());
    return names;
}

/// Draws a frame: its picture, or its sheet.
Picture draw_frame(const RenderCommand& command, const RenderedFrames& frames, std::size_t frame,
                   const SheetGrid& grid) {
    if (!command.is_sheet()) return frames.draw(frame, 0);
    std::vector<Picture> pictures;
    for (std::size_t i = 0; i < command.cells(); ++i)
        pictures.push_back(in_cell(command, i, [&] { return frames.draw(frame, i); }));
    return sheet_of(pictures, sheet_names(command), grid);
}

/// The grid of a command's sheet. Throws Error(usage) where it is larger than a picture can be.
SheetGrid grid_of(const RenderCommand& command) {
    const PictureSize cell = command.options.picture_options().size;
    const SheetGrid grid = sheet_grid(command.cells(), command.columns,
                                      {std::size_t(cell.width), std::size_t(cell.height)});
    const auto [width, height] = grid.size();
    if (std::max(width, height) > std::size_t(max_picture_side))
        throw Error(
            ExitCode::usage,
            fmt::format("a sheet of {} pictures of {} x {} would be {} x {}; its sides may "
                        "be {} at most, so make them smaller with --size",
                        command.cells(), cell.width, cell.height, width, height, max_picture_side));
    return grid;
}

}  // namespace

RenderedFrames rendered_frames(const RenderCommand& command, CommandFiles& files) {
    if (command.is_sheet()) grid_of(command);
    if (command.direct) return direct_frames(command, files);
    if (command.lazy) return lazy_frames(command, files);
    return scene_frames(command, files);
}

void write_frames(const RenderCommand& command, const RenderedFrames& frames) {
    const SheetGrid grid = command.is_sheet() ? grid_of(command) : SheetGrid{};
    const auto writer = frame_writer(command.paths(), command.file);
    Progress progress(progress_mode(command.progress, false));
    const auto count = std::size_t(command.file.frames);
    for (std::size_t i = 0; i < count; ++i) {
        progress.begin_round(i, count, "drawing");
        writer->add(draw_frame(command, frames, i, grid));
    }
    writer->commit();
    progress.finish();
    if (frames.write_report) frames.write_report();
}

}  // namespace burl
