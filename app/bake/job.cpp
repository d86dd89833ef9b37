#include "app/bake/job.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/bake/compress.h"
#include "app/bake/report.h"
#include "app/bake/up_to_date.h"
#include "app/base/atomic_file.h"
#include "app/base/messages.h"
#include "app/base/sha256.h"
#include "app/base/stopwatch.h"
#include "app/base/version.h"
#include "app/export/command_files.h"
#include "app/gl/fill/multipass_synthesizer.h"
#include "app/gl/fill/synthesizer.h"
#include "app/options/idle_options.h"
#include "app/pipeline/fill_texture.h"
#include "app/recipe/lattice_check.h"
#include "app/surface/load_pose.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

using Clock = std::chrono::steady_clock;

bool is_forward(const BakeCommand& command) {
    return command.kernel == forward_kernel;
}

/// The recipes of all frames, for the reference kernel if the command asks for it.
std::shared_ptr<const std::vector<Recipe>> recipes_of(const BakeCommand& command) {
    std::vector<Recipe> recipes = frame_recipes(command.recipe, command.animation);
    if (command.kernel == reference_kernel)
        std::for_each(recipes.begin(), recipes.end(), apply_reference);
    return std::make_shared<const std::vector<Recipe>>(std::move(recipes));
}

/// The files of the mesh, the pose and the recipe.
std::vector<std::string> files_read(const BakeCommand& command, const Recipe& recipe) {
    std::vector<std::string> files = files_of_mesh(command.mesh);
    if (is_pose_file(command.pose))
        std::ranges::move(files_of_mesh(command.pose), std::back_inserter(files));
    std::ranges::move(files_of_recipe(command.recipe.recipe, recipe), std::back_inserter(files));
    return files;
}

/// The plan of the command. Throws Error if an option is wrong or the recipe cannot be read.
BakePlan plan_of(const BakeCommand& command,
                 const std::shared_ptr<const std::vector<Recipe>>& recipes) {
    BakePlan plan;
    plan.kind = wanted_kind(command.out, command.bits());
    plan.paths = frame_paths(command.out, command.animation);
    plan.recipe = [recipes](std::size_t number) { return (*recipes)[number]; };
    plan.tell = [](const std::string& what) { warn(what); };
    plan.depth = command.bits();
    plan.crease_degrees = command.crease_degrees();
    const Recipe& first = recipes->front();
    plan.levels = levels_asked(command.levels, command.level_rule, first.atlas.size, plan.kind);
    plan.normals = normals_asked(command.normals, first, command.out);
    plan.compress = command.compress;
    plan.solid_map = command.solid_map;
    plan.shader = command.emitted_glsl;
    plan.threads = command.threads;
    return plan;
}

}  // namespace

BakeJob::BakeJob(const BakeCommand& command, const Json& settings)
    : command_(command),
      recipes_(recipes_of(command)),
      plan_(plan_of(command, recipes_)),
      inputs_(files_read(command, recipe())) {
    check();
    if (is_forward(command_)) std::ranges::for_each(*recipes_, check_forward);
    made_from_ = what_it_is_made_from(settings);
}

std::vector<std::string> BakeJob::texture_outputs(std::uint32_t levels) const {
    std::vector<std::string> outputs;
    for (const std::string& path : plan_.paths)
        for (std::string& file : output_paths(path, levels, has_normals()))
            outputs.push_back(std::move(file));
    return outputs;
}

std::vector<std::string> BakeJob::outputs(std::uint32_t levels) const {
    std::vector<std::string> outputs = texture_outputs(levels);
    for (const std::string& path : {command_.solid_map, command_.emitted_glsl})
        if (!path.empty()) outputs.push_back(path);
    return outputs;
}

/// Throws Error if an output would replace a file that is read or another output.
void BakeJob::check_files() const {
    CommandFiles files;
    files.read(inputs_);
    for (const std::string& path : texture_outputs(plan_.levels.count)) files.write(path);
    if (!command_.solid_map.empty()) files.write(command_.solid_map, ".exr");
    if (!command_.emitted_glsl.empty()) files.write(command_.emitted_glsl);
    if (!command_.report.empty() && command_.report != "-") files.write(command_.report);
    files.write(record_path(command_.out));
}

/// Checks the command before any work starts. Throws Error.
void BakeJob::check() const {
    if (command_.animation.asked() && holds_mesh(command_.out))
        throw Error(ExitCode::usage,
                    fmt::format("{}: --frames writes textures alone, .png or .exr; bake the mesh "
                                "once without --frames: its texture coordinates fit every frame",
                                command_.out));
    check_files();
    check_compress(command_.compress, recipe().atlas.kind);
    if (command_.compress && has_normals())
        throw Error(ExitCode::usage,
                    "--compress: blocks alike in colour may differ in their normals; add --normals "
                    "none to leave the bumps out");
    check_idle();
}

/// Throws Error(usage) if an option would have no effect.
void BakeJob::check_idle() const {
    const auto refuse = [&](std::string_view option, std::string_view why) {
        throw Error(ExitCode::usage, fmt::format("{}: {} does nothing: {}; leave it out",
                                                 command_.out, option, why));
    };
    const bool mesh = holds_mesh(command_.out), normals = has_normals();
    if (command_.depth && plan_.kind == ImageKind::rgb_float && !normals)
        refuse("--depth", "an .exr always has floats");
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
    refuse_moves(command_.animation.keys, {&still_pose, 1});
    check_edits(command_.recipe, recipe(), command_.animation.keys);
}

// OpenGL gives the bits of the kernels `direct` and `share`, so it takes no other kernel.
std::shared_ptr<TextureSynthesizer> BakeJob::synthesizer() const {
    const std::string &kernel = command_.kernel, &synth = command_.synth;
    const bool any = kernel == "auto" || kernel == "direct" || kernel == "share";
    const MultipassOptions multipass = command_.multipass.options(synth);
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
    const SynthesisChoice choice = synth == "host" || !any ? SynthesisChoice::host
                                   : synth == "gl"         ? SynthesisChoice::gl
                                                           : SynthesisChoice::automatic;
    return choose_synthesizer(choice, platform, *recipes_);
}

Json BakeJob::what_it_is_made_from(const Json& settings) const {
    std::vector<std::string> files = files_of_mesh(command_.mesh, MeshFiles::read);
    if (is_pose_file(command_.pose))
        std::ranges::move(files_of_mesh(command_.pose, MeshFiles::read), std::back_inserter(files));
    std::ranges::move(images_of_recipe(command_.recipe.recipe, recipe()),
                      std::back_inserter(files));
    Json made_from = {{"burl", burl_version()},
                      {"inputs", content_of(files, command_.recipe.images->digests())},
                      {"recipe", Json::parse(to_json(recipe()))},
                      {"options", settings}};
    if (files.empty() || files[0] != command_.mesh) made_from["sample"] = command_.mesh;
    if (recipes_->size() > 1) {
        Sha256 hash;
        for (const Recipe& recipe : *recipes_) hash.add(to_json(recipe));
        made_from["frames"] = hash.digest();
    }
    return made_from;
}

void BakeJob::set_up(Pipeline& pipeline, std::shared_ptr<TextureSynthesizer> synthesizer) const {
    pipeline.set_threads(command_.threads);
    pipeline.set_kernel(kernel_named(command_.kernel));
    pipeline.set_forward(is_forward(command_));
    pipeline.set_synthesizer(std::move(synthesizer));
    pipeline.set_skips(command_.economy.skips());
    pipeline.set_cache(command_.economy.cache_bytes(plan_.paths.size() > 1));
}

Json BakeJob::run(Pipeline& pipeline, std::shared_ptr<TextureSynthesizer> synthesizer,
                  double reading, LaterBake later) const {
    const auto start = Clock::now();
    for (const Recipe& recipe : *recipes_) check_lattice(recipe, pipeline.mesh());
    std::optional<MeshPose> pose;
    if (!command_.pose.empty())
        pose = load_pose(command_.mesh, command_.pose, command_.meshes.read);
    set_up(pipeline, synthesizer);
    const BakeResult result = bake(pipeline, plan_, pose ? &*pose : nullptr, later);
    Json seconds = {{"read", reading}};
    seconds.update(times_json(pipeline.records()));
    seconds["write"] = result.writing;
    seconds["total"] = reading + seconds_since(start);
    Json report = report_of(pipeline, result, synthesizer.get(), std::move(seconds));
    write_record(command_.out, made_from_, result.committed, report);
    return report;
}

/// The report of a bake, as `burl bake --report` writes it.
Json BakeJob::report_of(Pipeline& pipeline, const BakeResult& result,
                        const TextureSynthesizer* synthesizer, Json seconds) const {
    Json report = bake_json(command_.mesh, outputs(result.levels.count), recipe(), pipeline,
                            *result.metrics, result.levels, std::move(seconds));
    if (result.texture.compressed) report["compressed"] = compress_json(result.texture);
    if (synthesizer) report["synthesis"] = synthesizer->report();
    if (const auto& base = result.solid_base)
        report["solid_map"] = {{"file", command_.solid_map}, {"base", {base->x, base->y, base->z}}};
    if (result.normals && wants_report())
        report["normals"] = normals_json(pipeline, *result.normals, plan_.crease_degrees);
    if (!command_.animation.keys.empty()) report["animation"] = command_.animation.keys;
    return report;
}

std::optional<Json> BakeJob::known_report() const {
    if (command_.force || !command_.economy.skips().allows(Skip::up_to_date)) return std::nullopt;
    std::optional<Json> report = report_if_up_to_date(command_.out, made_from_);
    if (!report) return report;
    // The folder may have been moved, or may be named from another working directory.
    (*report)["input"] = command_.mesh;
    (*report)["outputs"] = outputs(report->at("mip_levels").get<std::uint32_t>());
    // Normals are measured only if a report is wanted, so the record may lack them.
    const bool lacks = has_normals() && !report->contains("normals");
    return lacks && wants_report() ? std::nullopt : report;
}

/// Writes the report to where the command wants it; returns whether a summary is to be printed.
bool BakeJob::write_reports(const Json& report) const {
    if (!command_.report.empty()) write_json(command_.report, report);
    if (command_.json) write_json("-", report);
    return !command_.json && !command_.quiet && command_.report != "-";
}

void BakeJob::print_up_to_date(Json report) const {
    report["up_to_date"] = true;
    if (write_reports(report)) print_line(fmt::format("{}: up to date", plan_.paths.front()));
}

void BakeJob::print(const Json& report) const {
    if (!write_reports(report)) return;
    print_summary(report, plan_.paths);
    if (report.contains("compressed")) print_compressed(report["compressed"]);
}

}  // namespace burl
