// `burl render`: a picture of a textured scene through OpenGL, of a recipe on a mesh as if it had
// been baked (--lazy), or of the texture itself in float64 (--direct).
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/base/atomic_file.h"
#include "app/base/messages.h"
#include "app/direct/picture.h"
#include "app/export/command_files.h"
#include "app/gl/device/context.h"
#include "app/gl/draw/lazy_picture.h"
#include "app/gl/draw/render.h"
#include "app/image/image_io.h"
#include "app/main/verbs.h"
#include "app/measure/report.h"
#include "app/options/animation.h"
#include "app/options/command_options.h"
#include "app/options/idle_options.h"
#include "app/pipeline/material.h"
#include "app/recipe/lattice_check.h"
#include "app/scene/scene.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

struct RenderCommand {
    DirectOptions options;
    AnimationOptions animation;
    EconomyOptions economy;
    std::string out, report, platform = gl_platforms()[0];
    std::optional<std::string> level_rule;
    bool direct = false, lazy = false;
};

TextureFilter parse_lookup(const std::string& text) {
    if (text == "nearest") return TextureFilter::nearest;
    if (text == "linear") return TextureFilter::linear;
    if (text == "mip") return TextureFilter::mip;
    throw Error(ExitCode::usage,
                fmt::format("--filter {}: it must be nearest, linear or mip; filters of the "
                            "texture itself go with --direct",
                            text));
}

/// Writes a picture, with its alpha where the background is transparent.
void write_drawn(const std::string& path, Image<Rgba8> picture, const PictureOptions& options) {
    if (options.background.kind != Background::Kind::transparent)
        return write_png(path, colors_and_alpha(std::move(picture)).first);
    AtomicFile file(path);
    encode_png(picture, sink_of(file));
    file.commit();
}

Image<Rgba8> draw_scene(const RenderCommand& command, CommandFiles& files) {
    const DirectOptions& options = command.options;
    if (options.scene.empty())
        throw Error(ExitCode::usage, "a scene is missing; --plane alone is for --direct");
    if (is_sample_mesh(options.scene))
        throw Error(ExitCode::usage,
                    fmt::format("{} is a mesh, not a baked scene; add --lazy or --direct, or bake "
                                "it first",
                                options.scene));
    std::optional<TextureFilter> filter;
    if (options.filter) filter = parse_lookup(*options.filter);
    const View view = options.parsed_view();
    const PictureOptions picture = options.picture_options();
    const Scene scene = load_scene(options.scene);
    for (const std::string& note : scene.notes) warn(note);
    files.read(scene.files);
    const Camera camera = orbit_camera(view, bounding_sphere(scene), picture.size);
    const std::unique_ptr<GlContext> context = create_gl_context(command.platform);
    context->make_current();
    const GlSurroundings around(context->gl(), scene, picture);
    return render_picture(*context, GlScene(context->gl(), scene, filter), around, camera, picture);
}

Json work_json(const LazyPicture& drawn) {
    const ViewWork& work = drawn.work;
    return {{"tiles", work.tiles},
            {"texels_read", work.texels_read},
            {"texels_synthesised", work.texels_made},
            {"texels_whole", work.texels_whole},
            {"octaves", work.synthesis.octaves},
            {"seconds",
             {{"finding", drawn.seconds_finding},
              {"synthesis", drawn.seconds_synthesis},
              {"drawing", drawn.seconds_drawing}}}};
}

/// Throws Error(usage) for --level-rule of a material whose pictures have no levels of their own.
void check_rule(const RenderCommand& command, const Recipe& recipe) {
    if (command.level_rule && has_pictures(recipe, Packing::gltf))
        throw Error(ExitCode::usage,
                    "--level-rule does nothing: the recipe's material varies in more than colour, "
                    "and its pictures have no MIP levels but OpenGL's averages; leave it out");
}

/// Draws a recipe on a mesh by --lazy. The report is written after the picture, so that it never
/// exists without one.
void write_lazily(const RenderCommand& command, CommandFiles& files) {
    const DirectOptions& options = command.options;
    if (options.scene.empty()) throw Error(ExitCode::usage, "--lazy: a mesh is missing");
    LazyOptions lazy;
    lazy.picture = options.picture_options();
    if (options.filter) lazy.filter = parse_lookup(*options.filter);
    lazy.crease_degrees = options.crease;
    lazy.skips = command.economy.skips();
    lazy.rule = level_rule_named(command.level_rule.value_or("direct"));
    const View view = options.parsed_view();
    const Recipe recipe = options.recipe.load();
    files.read(files_of_recipe(options.recipe.recipe, recipe));
    check_edits(options.recipe, recipe);
    check_rule(command, recipe);
    if (options.pose.empty()) refuse_edits(options.recipe, {&idle_pose, 1});
    Pipeline pipeline(options.meshes.load(options.scene));
    check_lattice(recipe, pipeline.mesh());
    pipeline.set_recipe(recipe);
    std::optional<MeshPose> pose;
    if (!options.pose.empty()) {
        pose = load_pose(options.scene, options.pose, options.meshes.read);
        lazy.pose = &*pose;
    }
    const std::unique_ptr<GlContext> context = create_gl_context(command.platform);
    const LazyPicture drawn = render_lazily(*context, pipeline, view, lazy);
    write_drawn(command.out, drawn.picture, lazy.picture);
    if (!command.report.empty()) write_json(command.report, work_json(drawn));
}

/// Draws the ground truth: one picture, or one per frame.
void draw_truth(const RenderCommand& command, const std::vector<std::string>& paths,
                CommandFiles& files) {
    const DirectOptions& options = command.options;
    const std::vector<PictureRecipes> frames = picture_recipes(options, command.animation);
    files.read(files_of_recipe(options.recipe.recipe, frames[0].main));
    for (std::size_t k = 0; k < options.planes.size(); ++k)
        if (const std::optional<Recipe>& recipe = frames[0].planes[k])
            files.read(files_of_recipe(parse_plane(options.planes[k]).recipe, *recipe));
    const DirectPicture draw(options);
    const PictureOptions picture = options.picture_options();
    for (std::size_t i = 0; i < paths.size(); ++i)
        write_drawn(paths[i], draw.with_alpha(frames[i]), picture);
}

/// Throws Error(usage) for options in `given`, those on the command line, that have no effect
/// together with the others.
void check_given(const RenderCommand& command, const std::vector<std::string>& given) {
    const DirectOptions& options = command.options;
    const auto refuse = [&](const std::vector<std::string>& idle, const char* why) {
        for (const std::string& option : idle)
            if (std::ranges::find(given, option) != given.end())
                throw Error(ExitCode::usage, fmt::format("{} {}", option, why));
    };
    if (!command.direct && !command.lazy) {
        refuse({"--recipe", "--set", "--time", "--precision", "--pose"},
               "goes with --direct or --lazy: a scene that is drawn has its texture already");
        refuse({"--crease", "--weld", "--unshare-instances"},
               "goes with --direct or --lazy: a scene is drawn as it is");
    }
    const bool headlight = options.light.light == "headlight";
    if (options.unlit || (headlight && !options.light.ground))
        refuse({"--rays"}, "is about an environment's light, which is not asked for; leave it out");
    if (options.unlit)
        refuse({"--crease"}, "is about light, and --unlit draws without; leave one of them out");
    if (options.widths)
        refuse({"--filter"}, "averages the colour, and --widths shows none; leave one of them out");
    if (command.lazy && options.filter && *options.filter != "mip")
        refuse({"--level-rule"}, "makes MIP levels, which only --filter mip looks up");
    const bool bare = std::ranges::any_of(
        options.planes, [](const std::string& text) { return parse_plane(text).recipe.empty(); });
    if (!options.scene.empty() || options.planes.empty()) return;
    refuse({"--crease", "--weld", "--unshare-instances"},
           "is about a mesh, and there are planes alone; leave it out");
    if (!bare)
        refuse({"--recipe"},
               "is shown nowhere: every plane names a recipe of its own; leave it out");
}

void run_render(const RenderCommand& command) {
    const std::vector<std::string> paths = frame_paths(command.out, command.animation);
    CommandFiles files;
    files.read(files_of_mesh(command.options.scene));
    if (is_pose_file(command.options.pose)) files.read(files_of_mesh(command.options.pose));
    files.read(command.options.light.files());
    for (const std::string& path : paths) files.write(path, ".png");
    if (!command.report.empty() && command.report != "-") files.write(command.report);
    if (command.direct) return draw_truth(command, paths, files);
    if (command.lazy) return write_lazily(command, files);
    write_drawn(command.out, draw_scene(command, files), command.options.picture_options());
}

}  // namespace

void add_render(CLI::App& program) {
    auto* verb =
        program.add_subcommand("render", "Picture of a textured scene, or of the exact texture");
    auto command = std::make_shared<RenderCommand>();
    command->options.add(*verb);
    verb->add_option("-o,--output", command->out, "Picture to write (.png)")->required();
    auto* direct = verb->add_flag(
        "--direct", command->direct,
        "Evaluate the recipe's texture for every sample, in float64: the ground truth");
    verb->add_option("--gl", command->platform,
                     "Draw with osmesa (software) or egl (a graphics processor)")
        ->capture_default_str()
        ->excludes(direct);
    auto* lazy = verb->add_flag("--lazy", command->lazy,
                                "Draw a mesh with the recipe's texture as if it had been baked; "
                                "only texels that the picture shows are worked out")
                     ->excludes(direct);
    verb->add_option("--report", command->report,
                     "Write what --lazy worked out as JSON to this file (- for stdout)")
        ->needs(lazy);
    verb->add_option("--level-rule", command->level_rule,
                     "How --lazy makes MIP levels, as burl bake does: average, direct or direct:N "
                     "(default direct)")
        ->needs(lazy);
    command->economy.add_skips(*verb);
    verb->get_option("--no-skip")->needs(lazy);
    command->animation.add(*verb);
    for (const char* option : {"--frames", "--plane", "--widths", "--rays"})
        verb->get_option(option)->needs(direct);
    verb->callback([command, verb] {
        std::vector<std::string> given;
        for (const CLI::Option* option : verb->get_options())
            if (option->count() > 0) given.push_back("--" + option->get_single_name());
        check_given(*command, given);
        run_render(*command);
    });
}

}  // namespace burl
