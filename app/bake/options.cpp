#include "app/bake/options.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/options/input_limits.h"
#include "app/pipeline/mask_picture.h"
#include "app/pipeline/material.h"
#include "app/recipe/parameters.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "procedural/batch/kernel.h"

namespace burl {

namespace {

/// Adds --kernel.
void add_kernel(CLI::App& verb, std::string& kernel) {
    std::vector<std::string> names;
    for (const NamedKernel& one : kernel_names) names.emplace_back(one.name);
    names.insert(names.end(), {forward_kernel, reference_kernel});
    verb.add_option(
            "--kernel", kernel,
            "How noise is computed: auto, the fastest; direct or share "
            "(cells hashed once for all their texels), with the same result; scanline (polynomials "
            "along rows, without a filter), which rounds otherwise; forward, by forward "
            "differences along scan lines "
            "in float64 (or --precision float32): value noise, no filter; or reference, texel by "
            "texel in float64, the same as --precision float64")
        ->check(one_of(names))
        ->capture_default_str();
}

/// Adds who makes the texture, and how OpenGL does.
void add_synthesis(CLI::App& verb, BakeCommand& command) {
    verb.add_option("--synth", command.synth,
                    "Who makes the texture: host, gl (OpenGL, the same texture), gl-multipass (the "
                    "papers' passes), or auto, which is gl where a graphics processor is behind "
                    "--gl and faster, by a measurement")
        ->check(one_of({"host", "gl", multipass_synth, "auto"}))
        ->capture_default_str();
    verb.add_option("--gl", command.platform,
                    "OpenGL of --synth: osmesa (software, the default) or egl (a graphics "
                    "processor)")
        ->check(one_of(std::vector<std::string>(gl_platforms().begin(), gl_platforms().end())));
    verb.add_option("--gl-precision", command.gl_precision,
                    "Images of --synth gl-multipass: 32f (the default), 16f or 8 bits a channel")
        ->check(one_of({"32f", "16f", "8"}));
    verb.add_option("--gl-randomizer", command.gl_randomizer,
                    "Random numbers of --synth gl-multipass: hash (the default, as on the host), "
                    "table, or bits (8 bits only)")
        ->check(one_of({"hash", "table", "bits"}));
    verb.add_flag("--gl-equalize", command.gl_equalize,
                  "Make the Gaussian numbers of --gl-randomizer bits white");
}

/// A validator of words between commas.
CLI::Validator list_of(const std::vector<std::string>& words) {
    return {[word = one_of(words)](std::string& text) {
                if (text.empty() || text.ends_with(','))
                    return fmt::format("\"{}\" ends without a word", text);
                for (std::size_t begin = 0; begin < text.size();) {
                    const std::size_t end = std::min(text.find(',', begin), text.size());
                    std::string one = text.substr(begin, end - begin);
                    if (std::string wrong = word(one); !wrong.empty()) return wrong;
                    begin = end + 1;
                }
                return std::string();
            },
            ""};
}

/// Adds --channels, a list of masks.
void add_channels(CLI::App& verb, BakeCommand& command) {
    const auto take = [&command](const std::vector<std::string>& lists) {
        for (const std::string& list : lists)
            std::ranges::move(CLI::detail::split(list, ','), std::back_inserter(command.channels));
    };
    const auto masks = mask_picture_names();
    verb.add_option_function<std::vector<std::string>>(
            "--channels", take,
            "Masks of the mesh's shape to write as NAME_MASK.png (or as --picture-format says), "
            "separated by commas: "
            "occlusion, curvature, thickness, facing, height_in_box, edge_distance, part, "
            "lighting")
        ->check(list_of({masks.begin(), masks.end()}))
        ->excludes("--compress");
}

/// Adds --udim, for which every option must work that is not excluded here.
void add_udim(CLI::App& verb, BakeCommand& command) {
    auto* udim =
        verb.add_flag("--udim", command.udim,
                      "With --atlas uv: write an image for each UDIM tile that the texture "
                      "coordinates lie in: NAME.1001.png, NAME.1002.png, ...");
    for (const char* option : {"--frames", "--solid-map", "--channels"})
        udim->excludes(verb.get_option(option));
}

/// Adds the options of normal maps and of a material's pictures.
void add_pictures(CLI::App& verb, BakeCommand& command) {
    verb.add_option("--normals", command.normals,
                    "Normal map of the recipe's bumps: tangent (the default; in the material of "
                    ".glb, .gltf and .obj, else beside as NAME_normal.png), object or none")
        ->check(one_of({"tangent", "object", "none"}));
    verb.add_option("--displace", command.displace,
                    "Move the mesh's points by the recipe's height, after splitting every triangle "
                    "in four this many times, in place of a normal map")
        ->check(CLI::Range(0, 8));
    verb.add_option("--pack", command.packing,
                    "Which of a material's channels share a picture: gltf (the default of .glb "
                    "and .gltf), unreal, unity, godot, or separate (the default of the others)")
        ->check(one_of({enum_names<Packing>.begin(), enum_names<Packing>.end()}));
    verb.add_flag("--vertex-colors", command.vertex_colors,
                  "Colours of the mesh's points, worked out exactly, in place of a texture and its "
                  "coordinates");
    verb.add_flag("--strips", command.strips,
                  "Write the mesh of a .glb, .gltf or .ply as triangle strips, which take fewer "
                  "indices than its triangles");
    verb.add_option("--normal-y", command.normal_y,
                    "Where the green of a normal map points: + (up, glTF, Godot, Unity) or - "
                    "(down, Unreal)")
        ->check(one_of({"+", "-"}))
        ->capture_default_str();
    verb.add_option("--depth", command.depth,
                    "Bits per channel: 8 or 16 of .png, 32 of .exr (in place of its half floats)")
        ->check(one_of({"8", "16", "32"}))
        ->default_str("8");
    verb.add_option("--picture-format", command.picture_format,
                    "Pictures in and beside the output: png (the default), jpeg, webp or ktx2, "
                    "with a quality where it is not theirs: jpeg:1 to :100 (90), webp:0 to :100 "
                    "(100, which loses nothing), ktx2:0 to :19 (zstd's level, 3)");
    verb.add_option("--crease", command.crease,
                    "Angle in degrees above which computed normals split")
        ->check(in_range(0.0, 180.0))
        ->default_str("40");
}

/// Adds the options of a glTF that is baked back into its own document.
void add_document(CLI::App& verb, BakeCommand& command) {
    command.meshes.add_choice(verb);
    verb.add_option("--assign", command.assigned,
                    "GLOB=RECIPE: the recipe for materials of a glTF with such names; may be "
                    "repeated, the first that matches counts. Other materials stay as they are, "
                    "unless --recipe says more")
        ->check([](const std::string& text) {
            const std::size_t at = text.find('=');
            const bool whole = at != std::string::npos && at > 0 && at + 1 < text.size();
            return whole ? "" : fmt::format("\"{}\" is not GLOB=RECIPE", text);
        });
    verb.add_option(
            "--atlas-per", command.atlas_per,
            "What of a glTF shares an atlas and its textures: the whole scene, all that has "
            "one recipe, each mesh, or each material")
        ->check(one_of({"scene", "recipe", "mesh", "material"}))
        ->capture_default_str();
    verb.add_option("--uv-set", command.uv_set,
                    "Set of a glTF's texture coordinates that gets the atlas's, the old ones from "
                    "there on moved up by one; left out: the first free one. With --atlas uv: the "
                    "set that is read, and stays; left out: 0")
        ->check(CLI::Range(0, 15));
    verb.add_flag("--strict", command.strict,
                  "Fail where the output cannot keep all that the mesh's file holds");
}

/// Whether no output depends on the option, or it is part of the recipe, or names the mesh or the
/// output.
bool counts_elsewhere(const std::string& name) {
    static constexpr std::array<std::string_view, 21> names = {
        "help",      "mesh",       "output",    "recipe",   "set",           "filter",
        "precision", "time",       "threads",   "no-skip",  "cache",         "force",
        "json",      "report",     "quiet",     "progress", "allow-outside", "max-triangles",
        "max-image", "max-noises", "max-memory"};
    return std::ranges::find(names, name) != names.end() ||
           std::ranges::any_of(parameters(), [&](const RecipeParameter& parameter) {
               return parameter.use.option.ends_with("--" + name);
           });
}

}  // namespace

std::vector<std::string> BakeCommand::recipe_losses() const {
    const std::vector<std::string>& losses = recipe.images->losses(recipe.recipe);
    if (strict && !losses.empty())
        throw Error(ExitCode::unsupported, fmt::format("--strict: {}", fmt::join(losses, "; ")));
    return losses;
}

void add_bake_options(CLI::App& verb, BakeCommand& command) {
    verb.add_option("mesh", command.mesh, "Mesh file: .obj .ply .stl .off .gltf .glb")->required();
    verb.add_option("-o,--output", command.out, "Output file; its extension says what")->required();
    command.recipe.add_recipe(verb);
    verb.get_option("--recipe")->each([&command](const std::string&) {
        command.recipe_given = true;
    });
    command.recipe.add_parameters(verb);
    command.animation.add(verb);
    command.recipe.add_filter(verb);
    command.recipe.add_precision(verb, "float32");
    command.meshes.add(verb);
    add_document(verb, command);
    add_pose(verb, command.pose);
    verb.add_option("--levels", command.levels,
                    "MIP levels to write besides the texture: a number, all, or all by a rule, "
                    "average, sharp or direct");
    verb.add_option("--level-rule", command.level_rule,
                    "MIP levels averaged from the level below (average, the default), with colours "
                    "sharpened against the blur of their lookup (sharp), or worked out from the "
                    "recipe: direct, 16 samples a texel, or direct:N, N being 1, 4, 16 or 64")
        ->needs("--levels");
    verb.add_option("--compress", command.compress,
                    "Quad atlas: blocks that differ by no more than this (0 to 1, full scale) "
                    "share a place, and the texture shrinks")
        ->check(in_range(0.0, 1.0))
        ->excludes("--levels");
    verb.add_option("--solid-map", command.solid_map,
                    "Write every texel's solid point and triangle to this .exr file, for shaders "
                    "elsewhere")
        ->excludes("--compress");
    add_channels(verb, command);
    for (const char* option : {"--levels", "--compress", "--solid-map", "--channels"})
        verb.get_option("--frames")->excludes(verb.get_option(option));
    add_udim(verb, command);
    verb.add_option(
        "--emit-glsl", command.emitted_glsl,
        "Write the whole material as a GLSL 3.30 fragment shader to this file, for engines");
    add_pictures(verb, command);
    add_kernel(verb, command.kernel);
    add_synthesis(verb, command);
    for (const char* option :
         {"--assign", "--atlas-per", "--uv-set", "--levels", "--compress", "--solid-map",
          "--channels", "--frames", "--normals", "--displace", "--pack", "--depth", "--filter",
          "--kernel", "--synth", "--gl", "--gl-precision", "--gl-randomizer", "--gl-equalize"})
        verb.get_option("--vertex-colors")->excludes(verb.get_option(option));
}

void add_run_options(CLI::App& verb, BakeCommand& command) {
    add_threads(verb, command.threads);
    add_input_limits(verb, command.meshes, command.recipe);
    command.economy.add_skips(verb);
    command.economy.add_cache(verb);
    verb.add_flag("--force", command.force, "Make outputs again that are up to date");
    add_progress(verb, command.progress);
}

void add_report_options(CLI::App& verb, BakeCommand& command) {
    verb.add_flag("--json", command.json, "Print the report as JSON on stdout");
    verb.add_option("--report", command.report,
                    "Write the report as JSON to this file (- for stdout)");
    verb.add_flag("-q,--quiet", command.quiet, "Print nothing on stdout");
}

void check_report_options(bool json, const std::string& report, bool quiet) {
    const char* const printing = json ? "--json" : report == "-" ? "--report -" : nullptr;
    if (printing && quiet)
        throw Error(ExitCode::usage,
                    fmt::format("{} prints the report and --quiet nothing; leave one of them out",
                                printing));
    if (json && report == "-")
        throw Error(ExitCode::usage,
                    "--json and --report - both print the report; leave one of them out");
}

Json bake_settings(const CLI::App& verb) {
    Json settings = Json::object();
    for (const CLI::Option* option : verb.get_options()) {
        const std::string name = option->get_single_name();
        if (counts_elsewhere(name)) continue;
        if (option->count() > 0)
            settings[name] = option->results();
        else if (!option->get_default_str().empty())
            settings[name] = {option->get_default_str()};
    }
    return settings;
}

}  // namespace burl
