#include "app/bake/job.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "app/bake/report.h"
#include "app/bake/tiles.h"
#include "app/bake/up_to_date.h"
#include "app/bake/vertex_colors.h"
#include "app/base/atomic_file.h"
#include "app/base/messages.h"
#include "app/base/stopwatch.h"
#include "app/export/command_files.h"
#include "app/export/formats.h"
#include "app/gl/fill/synthesizer.h"
#include "app/options/idle_options.h"
#include "app/options/input_limits.h"
#include "app/options/metres.h"
#include "app/pipeline/fill_texture.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/lattice_check.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

using Clock = std::chrono::steady_clock;

/// Sets the precision that --kernel reference means. Throws Error(usage) where the recipe asks for
/// another.
void apply_reference(Recipe& recipe) {
    if (recipe.precision.kind.value_or(PrecisionKind::float64) != PrecisionKind::float64)
        throw Error(ExitCode::usage,
                    "--kernel reference computes in float64, but another precision is asked for; "
                    "leave one of the two out");
    recipe.precision.kind = PrecisionKind::float64;
}

/// The kernel of this name in kernel_names; `automatic` for any other name.
Kernel kernel_named(const std::string& name) {
    const auto* found = std::ranges::find(kernel_names, name, &NamedKernel::name);
    return found == kernel_names.end() ? Kernel::automatic : found->kernel;
}

/// The files of the mesh, the pose and the recipe.
std::vector<std::string> files_read(const BakeCommand& command, const Recipe& recipe) {
    std::vector<std::string> files =
        files_of_mesh(command.mesh, MeshFiles::named, command.meshes.read.named);
    if (is_pose_file(command.pose))
        std::ranges::move(files_of_mesh(command.pose, MeshFiles::named, command.meshes.read.named),
                          std::back_inserter(files));
    std::ranges::move(files_of_recipe(command.recipe.recipe, recipe), std::back_inserter(files));
    return files;
}

/// The plan of the command; `sharing` are the recipes that share the atlas, if several do. Throws
/// Error if an option is wrong.
BakePlan plan_of(const BakeCommand& command,
                 const std::shared_ptr<const std::vector<Recipe>>& recipes,
                 const std::vector<Recipe>& sharing) {
    BakePlan plan;
    plan.kind = wanted_kind(command.out, command.bits());
    plan.paths = frame_paths(command.out, command.animation);
    plan.recipe = [recipes](std::size_t number) { return (*recipes)[number]; };
    plan.tell = [](const std::string& what) { warn(what); };
    plan.depth = command.bits();
    plan.coding = coding_asked(command.picture_format, command.out);
    plan.exr_depth = command.depth == 32 ? ExrDepth::full : ExrDepth::half;
    plan.crease_degrees = command.crease_degrees();
    const Recipe& first = recipes->front();
    plan.levels = levels_asked(command.levels, command.level_rule,
                               std::min(first.atlas.columns(), first.atlas.rows()), plan.kind);
    plan.displaces = command.displace.has_value();
    const std::string& normals =
        (plan.displaces || command.vertex_colors) && command.normals.empty() ? "none"
                                                                             : command.normals;
    const auto bumpy =
        std::ranges::find_if(sharing, [](const Recipe& recipe) { return !recipe.bump.empty(); });
    plan.normals = normals_asked(normals, bumpy == sharing.end() ? first : *bumpy, command.out);
    plan.normals_down = command.normal_y == "-";
    plan.packing = packing_asked(command.packing, command.out);
    plan.compress = command.compress;
    plan.channels = command.channels;
    plan.vertex_colors = command.vertex_colors;
    plan.strips = command.strips;
    plan.solid_map = command.solid_map;
    plan.shader = command.emitted_glsl;
    plan.threads = command.threads;
    return plan;
}

/// The options of --synth gl-multipass. Throws Error(usage) where one is given without it.
MultipassOptions multipass_options(const BakeCommand& command) {
    const std::string given = !command.gl_precision.empty()    ? "--gl-precision"
                              : !command.gl_randomizer.empty() ? "--gl-randomizer"
                              : command.gl_equalize            ? "--gl-equalize"
                                                               : "";
    if (command.synth != multipass_synth && !given.empty())
        throw Error(ExitCode::usage, fmt::format("{} is of --synth {}; add that or leave it out",
                                                 given, multipass_synth));
    MultipassOptions options;
    if (command.gl_precision == "16f") options.precision = PassPrecision::float16;
    if (command.gl_precision == "8") options.precision = PassPrecision::fixed8;
    if (command.gl_randomizer == "table") options.randomizer = Randomizer::table;
    if (command.gl_randomizer == "bits") options.randomizer = Randomizer::bits;
    options.equalize = command.gl_equalize;
    return options;
}

}  // namespace

std::shared_ptr<const std::vector<Recipe>> frames_of(const BakeCommand& command) {
    std::vector<Recipe> recipes = frame_recipes(command.recipe, command.animation);
    command.recipe_losses();
    if (command.kernel == reference_kernel) std::ranges::for_each(recipes, apply_reference);
    return std::make_shared<const std::vector<Recipe>>(std::move(recipes));
}

BakeJob::BakeJob(const BakeCommand& command, const Json& settings)
    : BakeJob(groups_of(command), settings) {}

BakeJob::BakeJob(std::vector<BakeGroup> groups, const Json& settings)
    : command_(groups.front().command),
      pictures_(groups.front().pictures),
      shares_(groups.front().shares),
      recipes_(frames_of(command_)),
      sharing_(load_shares()),
      plan_(plan_of(command_, recipes_, sharing_)),
      inputs_(files_read(command_, recipe())) {
    if (recipe().atlas.kind == AtlasKind::uv)
        command_.meshes.read.uv_set = command_.uv_set.value_or(0);
    for (std::size_t i = 1; i < shares_.size(); ++i)
        std::ranges::move(files_of_recipe(shares_[i].recipe.recipe, sharing_[i]),
                          std::back_inserter(inputs_));
    for (std::size_t g = 1; g < groups.size(); ++g) {
        others_.push_back(BakeJob({groups[g]}, settings));
        std::ranges::copy(others_.back().inputs_, std::back_inserter(inputs_));
    }
    check();
    if (command_.kernel == forward_kernel) std::ranges::for_each(*recipes_, check_forward);
    made_from_ = what_it_is_made_from(settings);
}

std::vector<std::string> BakeJob::outputs(const std::vector<std::string>& paths,
                                          std::uint32_t levels) const {
    std::vector<std::string> outputs;
    if (command_.vertex_colors)
        outputs = paths_without_texture(command_.out);
    else if (pictures_ != command_.out)
        outputs = document_outputs(levels);
    else
        for (const std::string& path : paths)
            std::ranges::move(paths_of(path, levels), std::back_inserter(outputs));
    for (const std::string& name : command_.channels)
        outputs.push_back(picture_path(command_.out, name, plan_.coding.format));
    for (const std::string& path : {command_.solid_map, command_.emitted_glsl})
        if (!path.empty()) outputs.push_back(path);
    return outputs;
}

/// Checks the command before any work starts. Throws Error.
void BakeJob::check() const {
    if (command_.animation.asked() && holds_mesh(command_.out))
        throw Error(
            ExitCode::usage,
            fmt::format("{}: --frames writes textures alone, .png or .exr, say; bake the mesh "
                        "once without --frames: its texture coordinates fit every frame",
                        command_.out));
    check_masks();
    check_files(plan_.paths);
    const AtlasKind kind = recipe().atlas.kind;
    if (command_.compress && kind != AtlasKind::quad)
        throw Error(ExitCode::usage,
                    fmt::format("--compress: only blocks of the quad atlas can share a place, this "
                                "one is {}; use --atlas quad",
                                to_string(kind)));
    if (command_.compress && has_normals())
        throw Error(ExitCode::usage,
                    "--compress: blocks alike in colour may differ in their normals; add --normals "
                    "none to leave the bumps out");
    check_displacement();
    check_coding();
    check_strips();
    check_bare_surface();
    check_uvs(command_, recipe(), plan_, kept_document());
    if (command_.vertex_colors) check_vertex_colors(command_.out, command_.recipe);
    if (!command_.pose.empty() && command_.meshes.read.choice.any())
        throw Error(
            ExitCode::usage,
            "--pose moves the whole mesh, and a choice of its parts some of it; leave one of "
            "the two out");
    for (const Recipe& recipe : *recipes_) check_material(recipe, plan_.material(), not_of(recipe));
    check_shares();
    check_idle();
    check_noises(command_.out, noises(), command_.recipe);
}

/// Throws Error(usage) if an option would have no effect.
void BakeJob::check_idle() const {
    const auto refuse = [&](std::string_view option, std::string_view why) {
        throw Error(ExitCode::usage, fmt::format("{}: {} does nothing: {}; leave it out",
                                                 command_.out, option, why));
    };
    const bool mesh = holds_mesh(command_.out), normals = has_normals();
    const bool pictures = normals || !command_.channels.empty();
    if (command_.depth.value_or(32) != 32 && plan_.kind == ImageKind::rgb_float && !pictures)
        refuse("--depth", "an .exr has half floats, or full ones with --depth 32");
    if (command_.normal_y == "-" && !normals) refuse("--normal-y", "there is no normal map");
    if (command_.normal_y == "-" && plan_.normals == NormalSpace::object)
        refuse("--normal-y -", "normals in object space have the mesh's own axes");
    if (command_.normal_y == "-" && holds_mesh(command_.out) && is_gltf(command_.out))
        refuse("--normal-y -", "the green of a glTF's normals points up");
    if (command_.normal_y == "-" && is_materialx(command_.out))
        refuse("--normal-y -", "the green of MaterialX's normals points up");
    if (!command_.packing.empty() && plan_.kind == ImageKind::rgb_float)
        refuse("--pack", "an .exr has a layer per channel");
    if (!command_.packing.empty() && picture_names(recipes_of_atlas(), plan_.material()).empty())
        refuse("--pack", "nothing but the recipe's colour varies");
    if (command_.crease && !mesh && !normals) refuse("--crease", "a texture alone has no normals");
    const auto why_no_kernel = [kernel = kernel_named(command_.kernel)](const Recipe& recipe) {
        return idle_kernel(recipe, kernel);
    };
    if (std::ranges::find(*recipes_, "", why_no_kernel) == recipes_->end())
        refuse("--kernel " + command_.kernel, why_no_kernel(recipe()));
    if (!command_.pose.empty() && !mesh)
        refuse("--pose", "a texture alone is the same in all of them");
    if (command_.pose.empty()) refuse_edits(command_.recipe, {&idle_pose, 1});
    constexpr IdleKey still_pose{"pose", "frames are textures alone, which no pose changes"};
    if (command_.animation.asked())
        refuse_edits(command_.recipe, {&still_pose, 1}, command_.animation.keys);
    check_edits(command_.recipe, recipe(), command_.animation.keys);
}

// OpenGL gives the bits of the kernels `direct` and `share`, so it takes no other kernel.
std::shared_ptr<TextureSynthesizer> BakeJob::synthesizer() const {
    const std::string &kernel = command_.kernel, &synth = command_.synth;
    const bool any = kernel == "auto" || kernel == "direct" || kernel == "share";
    const MultipassOptions multipass = multipass_options(command_);
    if (!any && synth.starts_with("gl"))
        throw Error(ExitCode::usage,
                    fmt::format("--kernel {} is the host's alone; leave it or --synth {} out",
                                kernel, synth));
    if (synth == "host" && !command_.platform.empty())
        throw Error(ExitCode::usage,
                    "--gl says where OpenGL comes from, and the host makes the texture; add "
                    "--synth gl, gl-multipass or auto, or leave --gl out");
    const std::string platform = command_.platform.empty() ? gl_platforms()[0] : command_.platform;
    if (synth == multipass_synth) return choose_multipass(multipass, platform, *recipes_);
    const bool host = synth == "host" || !any || needs_host();
    const SynthesisChoice choice = host            ? SynthesisChoice::host
                                   : synth == "gl" ? SynthesisChoice::gl
                                                   : SynthesisChoice::automatic;
    return choose_synthesizer(choice, platform, *recipes_);
}

BakeResult BakeJob::bake_into(Pipeline& pipeline, std::shared_ptr<TextureSynthesizer> synthesizer,
                              const std::shared_ptr<KeptScene>& kept, LaterBake later) const {
    std::vector<Recipe> recipes = *recipes_;
    set_metres(recipes, command_.recipe, command_.meshes.frame, pipeline.mesh());
    for (const Recipe& recipe : recipes) check_lattice(recipe, pipeline.mesh());
    std::optional<MeshPose> pose;
    if (!command_.pose.empty()) pose = command_.meshes.pose(command_.mesh, command_.pose);
    pipeline.set_threads(command_.threads);
    pipeline.set_kernel(kernel_named(command_.kernel));
    pipeline.set_forward(command_.kernel == forward_kernel);
    pipeline.set_synthesizer(std::move(synthesizer));
    pipeline.set_skips(command_.economy.skips());
    pipeline.set_cache(command_.economy.cache_bytes(plan_.paths.size() > 1));
    BakePlan plan = plan_;
    plan.recipe = [&recipes](std::size_t number) { return recipes[number]; };
    if (is_obj(command_.out) && !command_.displace)
        plan.obj = kept_obj(command_.mesh, pipeline.mesh(), command_.meshes.frame);
    if (command_.udim) {
        plan = plan_of_tiles(pipeline, plan, recipes[0]);
        check_files(plan.paths);
        check_tiles(plan.paths);
        check_noises(command_.out, noises() * double(plan.paths.size()), command_.recipe);
        if (plan.paths.size() > 1) later = std::max(later, LaterBake::mesh);
    }
    plan.kept = kept;
    if (pose) plan.pose_keys = pose_keys();
    plan.told = command_.told;
    if (kept) {
        prepare(*kept, command_.mesh, command_.meshes.read, pictures_,
                frame_transform(command_.meshes.frame));
        kept->labels = labels_of(kept->origins);
        plan.sharing = shared_recipes(pipeline.mesh());
    }
    pipeline.set_labels(kept ? kept->labels : std::vector<std::uint32_t>());
    const MeshPose* const posed = pose ? &*pose : nullptr;
    BakeResult result = plan.vertex_colors ? bake_vertex_colors(pipeline, plan, posed)
                                           : bake(pipeline, plan, posed, later);
    warn_of_strips(result.strips);
    return result;
}

Json BakeJob::run(Pipeline& pipeline, std::shared_ptr<TextureSynthesizer> synthesizer,
                  double reading, LaterBake later) const {
    const auto start = Clock::now();
    warn_of_values();
    warn_of_depth();
    const std::vector<std::string> flat = losses_before(pipeline.mesh());
    const std::shared_ptr<KeptScene> kept = kept_scene();
    if (kept) kept->is_last = others_.empty();
    BakeResult result = bake_into(pipeline, synthesizer, kept, later);
    if (!kept) result.lost = flat;
    Json seconds = {{"read", reading}};
    seconds.update(times_json(pipeline.records()));
    Json others = Json::array();
    bake_others(kept, result, others);
    seconds["write"] = result.writing;
    seconds["total"] = reading + seconds_since(start);
    Json report =
        report_of(pipeline, pipeline.recipe(), result, synthesizer.get(), std::move(seconds));
    if (!others.empty()) report["others"] = std::move(others);
    std::vector<std::string> lost = recipe_losses();
    std::ranges::copy(result.lost, std::back_inserter(lost));
    if (!lost.empty()) report["lost"] = lost;
    if (!result.lost.empty())
        warn(fmt::format("{}: {}", command_.out, losses_sentence(result.lost)));
    const std::vector<std::string> left = left_of_earlier_bake(command_.out, result.committed);
    if (!left.empty())
        warn(fmt::format("{}: left of an earlier bake: {}", command_.out, names_together(left)));
    write_record(command_.out, made_from_, result.committed, report);
    return report;
}

/// The report of a bake, as `burl bake --report` writes it.
Json BakeJob::report_of(Pipeline& pipeline, const Recipe& recipe, const BakeResult& result,
                        const TextureSynthesizer* synthesizer, Json seconds) const {
    if (plan_.vertex_colors)
        return vertex_colors_json(command_.mesh, outputs(plan_.paths, 0), recipe, pipeline, result,
                                  std::move(seconds));
    Json report = bake_json(command_.mesh, outputs(result.paths, result.levels.count), recipe,
                            pipeline, result, std::move(seconds));
    if (command_.udim) {
        // All charts were measured in one tile.
        Json& coverage = report["atlas"]["coverage"];
        coverage = coverage.get<double>() / double(result.paths.size());
        report["atlas"]["overlapped_texels"] = result.tile_notes->overlapped_texels;
        report["atlas"]["overlapping_triangles"] = result.tile_notes->overlapping_triangles;
        report["udim_paths"] = result.paths;
    }
    for (const Recipe& one : sharing_) report["recipes"].push_back(Json::parse(to_json(one)));
    if (synthesizer) report["synthesis"] = synthesizer->report();
    if (const auto& base = result.solid_base)
        report["solid_map"] = {{"file", command_.solid_map}, {"base", {base->x, base->y, base->z}}};
    if (result.normals && wants_report())
        report["normals"] = normals_json(pipeline, *result.normals, plan_.crease_degrees);
    if (!command_.animation.keys.empty()) report["animation"] = command_.animation.keys;
    return report;
}

void BakeJob::print(const Json& report) const {
    if (!command_.report.empty()) write_json(command_.report, report);
    if (command_.json) write_json("-", report);
    if (!command_.json && !command_.quiet && command_.report != "-")
        print_summary(report, command_.udim
                                  ? report.at("udim_paths").get<std::vector<std::string>>()
                                  : plan_.paths);
}

}  // namespace burl
