// `burl metrics`: the quality of an atlas by the papers' measures, for Burl's atlases and for a
// file's own texture coordinates.
#include <bit>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/base/messages.h"
#include "app/base/progress.h"
#include "app/export/command_files.h"
#include "app/main/verbs.h"
#include "app/measure/measuring.h"
#include "app/options/command_options.h"
#include "app/options/idle_options.h"
#include "app/options/input_limits.h"
#include "app/options/metres.h"
#include "app/pipeline/tasks.h"
#include "app/recipe/parameters.h"
#include "app/recipe/presets.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

struct MetricsCommand {
    std::string mesh;
    std::string texture, fill = "extrapolate", level_rule = "average";
    RecipeOptions recipe;
    MeshOptions meshes;
    std::string image;  // prefix of pictures; empty: none
    std::optional<std::string> view;
    bool recipe_given = false;
    bool uv = false, levels = false, json = false;
    std::string progress = "auto";
};

/// The way to fill gaps, by the name that --fill takes.
GapFill gap_fill(const std::string& name) {
    if (name == "black") return GapFill::black;
    return name == "nearest" ? GapFill::nearest : GapFill::extrapolate;
}

/// Loads the mesh. Throws Error(usage) where --uv asks for texture coordinates that it does not
/// have.
Mesh load_measured(const MetricsCommand& command) {
    Mesh mesh = command.meshes.load(command.mesh);
    if (command.uv && mesh.corners.uvs.empty())
        throw Error(ExitCode::usage,
                    fmt::format("{} has no texture coordinates: leave out --uv to measure an atlas "
                                "of ours",
                                command.mesh));
    return mesh;
}

std::vector<AtlasKind> kinds_asked(const MetricsCommand& command, const Recipe& recipe) {
    if (command.recipe.given("atlas.kind") != "all") return {recipe.atlas.kind};
    if (!std::has_single_bit(recipe.atlas.size))
        warn("quad is left out: its size must be a power of two");
    return all_atlas_kinds(recipe.atlas.size);
}

/// Throws Error(io) where a picture would replace a file that is read, or cannot be written.
void check_pictures(const MetricsCommand& command, const Recipe& recipe, bool uvs,
                    const std::vector<AtlasKind>& kinds) {
    if (command.image.empty()) return;
    CommandFiles files;
    files.read(files_of_mesh(command.mesh, MeshFiles::named, command.meshes.read.named));
    files.read(files_of_recipe(command.recipe.recipe, recipe));
    for (const char* topic : picture_topics) {
        if (uvs) files.write(measured_picture(command.image, "uv", topic));
        for (const AtlasKind kind : kinds)
            files.write(measured_picture(command.image, measured_name(kind), topic));
    }
}

/// Throws Error(usage) for edits without effect; edits of the texture have one only where it is
/// looked up.
void check_recipe(const MetricsCommand& command, const RecipeOptions& options,
                  const Recipe& recipe) {
    const bool looked_up =
        (command.levels || !command.image.empty()) && command.texture == "recipe";
    const char* const why = looked_up ? "metrics looks up the texture alone"
                                      : "metrics looks up no texture of the recipe; add --levels "
                                        "and --texture recipe";
    std::vector<IdleKey> keys{{"bump", why}, {"filter", why}, {"paint", why}, {"pose", why}};
    if (!looked_up)
        for (const char* key : {"solid", "texture", "precision"}) keys.push_back({key, why});
    refuse_edits(options, keys);
    if (options.time && !looked_up)
        throw Error(ExitCode::usage, fmt::format("--time does nothing: {}; leave it out", why));
    if (command.recipe.given("atlas.kind") != "all") check_edits(options, recipe);
}

/// Throws Error(usage) for one of Burl's own recipes, which all have the usual atlas, where its
/// texture is not looked up.
void check_recipe_used(const MetricsCommand& command) {
    const std::string& recipe = command.recipe.recipe;
    if (!command.recipe_given || command.levels || !command.image.empty() || !names_preset(recipe))
        return;
    throw Error(ExitCode::usage,
                fmt::format("--recipe {} does nothing: metrics looks up no texture; add --levels "
                            "or --image, or leave it out",
                            recipe));
}

/// Throws Error(usage) for options of Burl's atlases where only the file's own texture coordinates
/// are measured.
void check_uv_options(const MetricsCommand& command) {
    for (const RecipeEdit& edit : command.recipe.edits())
        if (edit.path.starts_with("atlas.") && edit.path != "atlas.size")
            throw Error(ExitCode::usage,
                        fmt::format("{} is of our atlases, and {}'s own texture coordinates are "
                                    "measured; add --atlas, or leave it out",
                                    edit.said, command.mesh));
}

/// The atlases to measure.
struct AtlasesAsked {
    bool uvs = false;  ///< the file's own texture coordinates
    std::vector<AtlasKind> kinds;
};

/// The atlases that the options ask for. Throws Error for options that do not fit them, and for
/// their pictures' paths.
AtlasesAsked atlases_asked(const MetricsCommand& command, const Recipe& recipe, const Mesh& mesh) {
    const bool has_uvs = !mesh.corners.uvs.empty(),
               asked = command.recipe.given("atlas.kind").has_value();
    AtlasesAsked result{command.uv || (has_uvs && !asked), {}};
    if (result.uvs && !asked) check_uv_options(command);
    if (asked || !result.uvs) result.kinds = kinds_asked(command, recipe);
    check_pictures(command, recipe, result.uvs, result.kinds);
    return result;
}

void run_metrics(const MetricsCommand& command) {
    RecipeOptions options = command.recipe;
    if (options.given("atlas.kind") == "all")
        std::erase_if(options.parameters, [](const ParameterOption& option) {
            return option.parameter->path == "atlas.kind";
        });
    Progress progress(progress_mode(command.progress, false));
    progress.begin_item("", 0, 1, tasks::read);
    Recipe recipe = options.load();
    check_recipe(command, options, recipe);
    check_recipe_used(command);
    check_square(recipe.atlas);
    Mesh mesh = load_measured(command);
    set_metres({&recipe, 1}, options, command.meshes.frame, mesh);
    const AtlasesAsked asked = atlases_asked(command, recipe, mesh);
    const MeasuringPlan plan{recipe,
                             command.texture == "recipe",
                             command.levels,
                             command.level_rule == "sharp",
                             gap_fill(command.fill),
                             command.image,
                             command.view ? parse_view(*command.view) : View{},
                             {},
                             progress.meter()};
    check_noises(command.mesh, noises_of_measuring(plan, mesh, asked.uvs, asked.kinds.size()),
                 options);
    Measuring measuring(plan, std::move(mesh));
    std::vector<MeasuredAtlas> atlases = measuring.all(asked.uvs, asked.kinds);
    progress.finish();
    if (command.json) {
        write_json("-", measuring.json(atlases));
        return;
    }
    fmt::print("{} triangles, {} without area\n", measuring.mesh().triangles.size(),
               measuring.mesh().notes.degenerate_triangles);
    print_measures(atlases);
}

}  // namespace

void add_metrics(CLI::App& program) {
    auto* verb = program.add_subcommand(
        "metrics", "Measure an atlas, or the texture coordinates a file brings");
    auto command = std::make_shared<MetricsCommand>();
    verb->add_option("mesh", command->mesh, "Mesh file: .obj .ply .stl .off .gltf .glb")
        ->required();
    command->recipe.add_recipe(*verb);
    command->recipe.add_parameters(*verb);
    verb->get_option("--atlas")->description(
        fmt::format("Atlas: {}, or all", fmt::join(enum_names<AtlasKind>, ", ")));
    verb->get_option("--size")->description("Side N of the N x N texture, in texels");
    verb->add_flag("--uv", command->uv,
                   "Measure the file's own texture coordinates (the default for a file that has "
                   "them when no --atlas is asked)");
    command->meshes.add(*verb);
    command->meshes.add_uv_set(*verb);
    verb->add_flag("--levels", command->levels,
                   "Also measure lookups: error per MIP level, seams, bleeding, sampled views");
    auto* texture =
        verb->add_option("--texture", command->texture,
                         "What is looked up: metric-marble, or the recipe's texture (default: the "
                         "recipe's if --recipe is given)");
    texture->check(one_of({metric_marble_name, "recipe"}));
    verb->add_option("--fill", command->fill,
                     "Texels that show no triangle: extrapolate (the surface goes on for two "
                     "texels), nearest (copied) or black")
        ->check(one_of({"extrapolate", "nearest", "black"}))
        ->capture_default_str();
    verb->add_option("--level-rule", command->level_rule,
                     "MIP levels that are looked up: average, or sharp, as burl bake makes them")
        ->check(one_of({"average", "sharp"}))
        ->capture_default_str();
    verb->add_option("--image", command->image,
                     "Draw PREFIX-ATLAS-charts.png, -scale.png and -levels.png");
    verb->add_option("--view", command->view,
                     "Where --image looks from: AZ,EL,DIST as in burl render (default 30,20,3.5)");
    verb->add_flag("--json", command->json, "Print JSON");
    add_progress(*verb, command->progress);
    add_input_limits(*verb, command->meshes, command->recipe);
    verb->get_option("--view")->needs("--image");
    verb->callback([command, verb, texture] {
        for (const char* option : {"--texture", "--fill", "--level-rule"})
            if (verb->count(option) > 0 && !command->levels && command->image.empty())
                throw Error(ExitCode::usage,
                            fmt::format("{} is about lookups; add --levels or --image, or leave it "
                                        "out",
                                        option));
        command->recipe_given = verb->get_option("--recipe")->count() > 0;
        if (texture->count() == 0)
            command->texture = command->recipe_given ? "recipe" : metric_marble_name;
        run_metrics(*command);
    });
}

}  // namespace burl
