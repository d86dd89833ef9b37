// `burl bake`: a mesh without UVs in, a textured scene out (the whole pipeline, headless).
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>

#include <fmt/format.h>

#include "app/animation.h"
#include "app/atomic_file.h"
#include "app/bake_compress.h"
#include "app/bake_levels.h"
#include "app/bake_normals.h"
#include "app/bake_report.h"
#include "app/command_options.h"
#include "app/economy_options.h"
#include "app/export.h"
#include "app/forward_check.h"
#include "app/gl_emit.h"
#include "app/gl_multipass_synthesizer.h"
#include "app/gl_synthesizer.h"
#include "app/lattice_check.h"
#include "app/multipass_options.h"
#include "app/solid_map_file.h"
#include "app/verbs.h"
#include "atlas/error.h"

namespace burl {

namespace {

struct BakeCommand {
    std::string mesh, out, report;
    RecipeOptions recipe;
    AnimationOptions animation;
    MeshOptions meshes;
    EconomyOptions economy;
    int threads = 0, depth = 8;
    double crease = 40.0;
    std::string levels, level_rule, normals, solid_map, emitted_glsl, kernel = "auto";
    std::string synth = "host", platform = gl_platforms()[0];
    MultipassCommand multipass;
    std::optional<double> compress;
    bool json = false, quiet = false;
};

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

BakedImage synthesize(Pipeline& pipeline, ImageKind kind) {
    if (kind == ImageKind::rgb16) return pipeline.synthesize<Rgb16>();
    if (kind == ImageKind::rgb_float) return pipeline.synthesize<RgbF>();
    return pipeline.synthesize<Rgb8>();
}

/// The texture in the kind the file wants; levels go into the options.
BakedImage synthesize(Pipeline& pipeline, ImageKind kind, const LevelsAsked& levels,
                      ExportOptions& options) {
    if (levels.count == 0) return synthesize(pipeline, kind);
    Image<RgbF> texture = pipeline.synthesize<RgbF>();
    options.levels = bake_levels(pipeline, texture, levels, kind);
    return convert_to(std::move(texture), kind);
}

/// Said before any work starts (DESIGN section 6).
void warn_if_starved(const Pipeline& pipeline) {
    const std::string problem =
        shortage(capacity(pipeline.mesh().triangles.size(), pipeline.recipe().atlas));
    if (!problem.empty()) warn(fmt::format("{}: {}", pipeline.mesh().name, problem));
}

void tell_fallback(Pipeline& pipeline) {
    const std::string& why = pipeline.atlas().notes.fallback;
    if (!why.empty()) warn(fmt::format("{}: {}", pipeline.mesh().name, why));
}

/// What is written besides the texture.
struct Extras {
    LevelsAsked levels{};
    NormalSpace normals = NormalSpace::none;
    bool has_normals() const { return normals != NormalSpace::none; }
};

/// The files of the textures and the scene.
std::vector<std::string> texture_outputs(const BakeCommand& command, const Extras& extras) {
    std::vector<std::string> outputs;
    for (const std::string& path : frame_paths(command.out, command.animation))
        for (std::string& file : output_paths(path, extras.levels.count, extras.has_normals()))
            outputs.push_back(std::move(file));
    return outputs;
}

/// Every file that will be written.
std::vector<std::string> all_outputs(const BakeCommand& command, const Extras& extras) {
    std::vector<std::string> outputs = texture_outputs(command, extras);
    for (const std::string& path : {command.solid_map, command.emitted_glsl})
        if (!path.empty()) outputs.push_back(path);
    return outputs;
}

/// Every file that is read.
std::vector<std::string> all_inputs(const BakeCommand& command, const Recipe& recipe) {
    std::vector<std::string> inputs{command.mesh, command.recipe.recipe};
    const auto folder = std::filesystem::path(command.recipe.recipe).parent_path();
    for (const GraphImage& image : recipe.graph.images) inputs.push_back(folder / image.file);
    return inputs;
}

/// What is written beside the textures must leave them, one another and all that is read alone.
void check_side_outputs(const BakeCommand& command, const Recipe& recipe, const Extras& extras) {
    std::vector<std::string> taken = texture_outputs(command, extras);
    std::ranges::move(all_inputs(command, recipe), std::back_inserter(taken));
    const auto check = [&](const std::string& path, std::string_view extension) {
        if (path.empty() || path == "-") return;
        check_side_output(path, extension, taken);
        taken.push_back(path);
    };
    check(command.solid_map, ".exr");
    check(command.emitted_glsl, "");
    check(command.report, "");
}

/// Everything that the command line can be wrong about, before any work starts.
void check_command(const BakeCommand& command, const Recipe& recipe, const Extras& extras) {
    if (command.animation.asked() && holds_mesh(command.out))
        throw Error(ExitCode::usage,
                    fmt::format("{}: --animate writes textures alone, .png or .exr; bake the mesh "
                                "once without --animate: its texture coordinates fit every frame",
                                command.out));
    for (const std::string& path : frame_paths(command.out, command.animation))
        check_output(path, command.mesh, extras.levels.count, extras.has_normals());
    check_side_outputs(command, recipe, extras);
    check_compress(command.compress, recipe.atlas.kind);
    if (command.compress && extras.has_normals())
        throw Error(ExitCode::usage,
                    "--compress: blocks alike in colour may differ in their normals; add --normals "
                    "none to leave the bumps out");
}

/// Who makes the textures; null: the host. OpenGL has the bits of the kernels that share theirs.
std::shared_ptr<TextureSynthesizer> synthesizer_of(const BakeCommand& command,
                                                   std::span<const Recipe> recipes) {
    const bool any =
        command.kernel == "auto" || command.kernel == "direct" || command.kernel == "share";
    const MultipassOptions multipass = command.multipass.options(command.synth);
    if (!any && command.synth.starts_with("gl"))
        throw Error(ExitCode::usage,
                    fmt::format("--kernel {} is the host's alone; leave it or --synth {} out",
                                command.kernel, command.synth));
    if (command.synth == multipass_synth)
        return choose_multipass(multipass, command.platform, recipes);
    const SynthesisChoice choice = command.synth == "host" || !any ? SynthesisChoice::host
                                   : command.synth == "gl"         ? SynthesisChoice::gl
                                                                   : SynthesisChoice::automatic;
    return choose_synthesizer(choice, command.platform, recipes);
}

/// Strips may not hold the mesh at all, which is then the one thing to say.
void lay_out(Pipeline& pipeline) {
    const AtlasKind kind = pipeline.recipe().atlas.kind;
    const bool strips = kind != AtlasKind::patch && kind != AtlasKind::quad;
    if (!strips) warn_if_starved(pipeline);
    tell_fallback(pipeline);
    if (strips) warn_if_starved(pipeline);
}

struct Written {
    BakedAtlas baked;
    std::optional<NormalMap> normals{};
    std::size_t levels = 0;
    double seconds = 0.0;
};

/// The pipeline's recipe as a texture in its file.
Written write_texture(const BakeCommand& command, Pipeline& pipeline, const std::string& path,
                      ImageKind kind, const Extras& extras) {
    ExportOptions options;
    Written written{compressed_bake(
        pipeline.atlas(), synthesize(pipeline, kind, extras.levels, options), command.compress)};
    options.normals = bake_normals(pipeline, extras.normals, command.depth, command.crease);
    const auto writing = Clock::now();
    options.crease_degrees = command.crease;
    options.recipe_json = to_json(pipeline.recipe());
    export_scene(path, pipeline.atlas_mesh(), written.baked.atlas, written.baked.image, options);
    written.levels = options.levels.size();
    written.normals = std::move(options.normals);
    written.seconds = seconds_since(writing);
    return written;
}

/// The texture as a shader, where it is asked for.
std::string emitted_shader(const BakeCommand& command, const Recipe& recipe, const Mesh& mesh) {
    return command.emitted_glsl.empty() ? "" : emit_glsl(recipe, texture_from_mesh(recipe, mesh));
}

void run_bake(const BakeCommand& command) {
    const auto start = Clock::now();
    const ImageKind kind = wanted_kind(command.out, command.depth);
    const std::vector<std::string> paths = frame_paths(command.out, command.animation);
    std::vector<Recipe> recipes = frame_recipes(command.recipe, command.animation);
    if (command.kernel == reference_kernel)
        std::for_each(recipes.begin(), recipes.end(), apply_reference);
    Extras extras{levels_asked(command.levels, command.level_rule, recipes[0].atlas.size, kind),
                  normals_asked(command.normals, recipes[0], command.out)};
    check_command(command, recipes[0], extras);
    const bool forward = command.kernel == forward_kernel;
    if (forward) std::for_each(recipes.begin(), recipes.end(), check_forward);
    const std::shared_ptr<TextureSynthesizer> synthesizer = synthesizer_of(command, recipes);
    Pipeline pipeline(command.meshes.load(command.mesh));
    const double reading = seconds_since(start);
    for (const Recipe& recipe : recipes) check_lattice(recipe, pipeline.mesh());
    const std::string shader = emitted_shader(command, recipes[0], pipeline.mesh());
    pipeline.set_recipe(recipes[0]);
    pipeline.set_threads(command.threads);
    pipeline.set_kernel(kernel_named(command.kernel));
    pipeline.set_forward(forward);
    pipeline.set_synthesizer(synthesizer);
    pipeline.set_skips(command.economy.skips());
    pipeline.set_cache(command.economy.cache_bytes(paths.size() > 1));
    lay_out(pipeline);
    Written written;
    double writing = 0.0;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        if (i > 0) pipeline.set_recipe(recipes[i]);
        written = write_texture(command, pipeline, paths[i], kind, extras);
        writing += written.seconds;
    }
    if (!command.emitted_glsl.empty()) write_file(command.emitted_glsl, shader);
    Json solid_map;
    if (!command.solid_map.empty()) {
        const Vec3d base = write_solid_map(command.solid_map, pipeline, command.threads);
        solid_map = {{"file", command.solid_map}, {"base", {base.x, base.y, base.z}}};
    }
    Json seconds = {{"read", reading}};
    seconds.update(times_json(pipeline.records()));
    seconds["write"] = writing;
    seconds["total"] = seconds_since(start);
    Json normals;
    if (written.normals && (command.json || !command.report.empty()))
        normals = normals_json(pipeline, *written.normals, command.crease);
    extras.levels.count = std::uint32_t(written.levels);
    Json report = bake_json(command.mesh, all_outputs(command, extras), recipes[0], pipeline,
                            extras.levels, std::move(seconds));
    const BakedAtlas& baked = written.baked;
    if (baked.compressed) report["compressed"] = compress_json(baked);
    if (synthesizer) report["synthesis"] = synthesizer->report();
    if (!solid_map.empty()) report["solid_map"] = std::move(solid_map);
    if (!normals.empty()) report["normals"] = std::move(normals);
    if (command.animation.asked()) report["animation"] = command.animation.keys;
    if (!command.report.empty()) write_json(command.report, report);
    if (command.json) {
        write_json("-", report);
    } else if (!command.quiet && command.report != "-") {
        print_summary(report, paths);
        if (baked.compressed) print_compressed(baked);
    }
}

}  // namespace

void add_bake(CLI::App& program) {
    auto* verb =
        program.add_subcommand("bake", "Texture a mesh and write .glb, .gltf, .obj, .png or .exr");
    auto command = std::make_shared<BakeCommand>();
    verb->add_option("mesh", command->mesh, "Mesh file: .obj .ply .stl .off .gltf .glb")
        ->required();
    verb->add_option("-o,--output", command->out, "Output file; its extension says what")
        ->required();
    command->recipe.add_recipe(*verb);
    command->recipe.add_atlas(*verb);
    command->animation.add(*verb);
    verb->add_option("--filter", command->recipe.filter,
                     "Texel filter: none, table-mip, table-sat, table-sat3, exact, trapezoid, "
                     "trapezoid2 or supersample:N");
    command->recipe.add_precision(*verb, "float32");
    command->meshes.add(*verb);
    verb->add_option("--levels", command->levels,
                     "MIP levels to write besides the texture: a number, all, or all by a rule, "
                     "average or direct");
    verb->add_option("--level-rule", command->level_rule,
                     "MIP levels averaged from the level below (average, the default), or worked "
                     "out from the recipe: direct, 16 samples a texel, or direct:N, N being 1, 4, "
                     "16 or 64")
        ->needs("--levels");
    verb->add_option("--compress", command->compress,
                     "Quad atlas: blocks that differ by no more than this (0 to 1, full scale) "
                     "share a place, and the texture shrinks")
        ->check(in_range(0.0, 1.0))
        ->excludes("--levels");
    verb->add_option("--solid-map", command->solid_map,
                     "Write every texel's solid point and triangle to this .exr file, for shaders "
                     "elsewhere")
        ->excludes("--compress");
    for (const char* option : {"--levels", "--compress", "--solid-map"})
        verb->get_option("--animate")->excludes(verb->get_option(option));
    verb->add_option("--emit-glsl", command->emitted_glsl,
                     "Write the texture as a GLSL 3.30 fragment shader to this file, for engines");
    verb->add_option("--normals", command->normals,
                     "Normal map of the recipe's bumps: tangent (the default; in the material of "
                     ".glb, .gltf and .obj, else beside as NAME_normal.png), object or none")
        ->check(CLI::IsMember({"tangent", "object", "none"}));
    verb->add_option("--depth", command->depth, "Bits per channel of .png textures")
        ->check(CLI::IsMember({8, 16}))
        ->capture_default_str();
    verb->add_option("--crease", command->crease,
                     "Angle in degrees above which computed normals split")
        ->check(in_range(0.0, 180.0))
        ->capture_default_str();
    add_threads(*verb, command->threads);
    add_kernel(*verb, command->kernel);
    command->economy.add_skips(*verb);
    command->economy.add_cache(*verb);
    verb->add_option(
            "--synth", command->synth,
            "Who makes the texture: host, gl (OpenGL, the same texture), gl-multipass (the "
            "papers' passes), or auto, which is gl where a graphics processor is behind "
            "--gl")
        ->check(CLI::IsMember({"host", "gl", multipass_synth, "auto"}))
        ->capture_default_str();
    verb->add_option("--gl", command->platform,
                     "OpenGL of --synth: osmesa (software) or egl (a graphics processor)")
        ->check(
            CLI::IsMember(std::vector<std::string>(gl_platforms().begin(), gl_platforms().end())))
        ->capture_default_str();
    command->multipass.add(*verb);
    verb->add_flag("--json", command->json, "Print the report as JSON on stdout");
    verb->add_option("--report", command->report,
                     "Write the report as JSON to this file (- for stdout)");
    verb->add_flag("-q,--quiet", command->quiet, "Print nothing on stdout");
    verb->callback([command] { run_bake(*command); });
}

}  // namespace burl
