#include "app/bake/job.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/bake/compress.h"
#include "app/bake/exr.h"
#include "app/bake/levels.h"
#include "app/bake/report.h"
#include "app/bake/texture.h"
#include "app/bake/up_to_date.h"
#include "app/base/atomic_file.h"
#include "app/base/messages.h"
#include "app/base/sha256.h"
#include "app/base/version.h"
#include "app/export/command_files.h"
#include "app/export/emit.h"
#include "app/export/solid_map_file.h"
#include "app/gl/fill/multipass_synthesizer.h"
#include "app/gl/fill/synthesizer.h"
#include "app/options/idle_options.h"
#include "app/recipe/forward_check.h"
#include "app/recipe/lattice_check.h"
#include "app/surface/load_pose.h"
#include "atlas/base/error.h"
#include "atlas/base/freed_memory.h"
#include "atlas/build/atlas_pose.h"

namespace burl {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
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

/// Strips may not hold the mesh at all, which is then the one thing to say.
void lay_out(Pipeline& pipeline) {
    const AtlasKind kind = pipeline.recipe().atlas.kind;
    const bool strips = kind != AtlasKind::patch && kind != AtlasKind::quad;
    if (!strips) warn_if_starved(pipeline);
    tell_fallback(pipeline);
    if (strips) warn_if_starved(pipeline);
}

bool is_forward(const BakeCommand& command) {
    return command.kernel == forward_kernel;
}

std::vector<Recipe> recipes_of(const BakeCommand& command) {
    std::vector<Recipe> recipes = frame_recipes(command.recipe, command.animation);
    if (command.kernel == reference_kernel)
        std::for_each(recipes.begin(), recipes.end(), apply_reference);
    return recipes;
}

std::vector<std::string> files_read(const BakeCommand& command, const Recipe& recipe) {
    std::vector<std::string> files = files_of_mesh(command.mesh);
    if (is_pose_file(command.pose))
        std::ranges::move(files_of_mesh(command.pose), std::back_inserter(files));
    std::ranges::move(files_of_recipe(command.recipe.recipe, recipe), std::back_inserter(files));
    return files;
}

/// The texture as a shader, where it is asked for.
std::string emitted_shader(const BakeCommand& command, const Recipe& recipe, const Mesh& mesh) {
    return command.emitted_glsl.empty() ? "" : emit_glsl(recipe, texture_from_mesh(recipe, mesh));
}

}  // namespace

struct BakeJob::Written {
    BakedAtlas baked;
    std::optional<NormalMap> normals{};
    std::size_t levels = 0;
    std::vector<AtomicFile> files{};
    double seconds = 0.0;
};

BakeJob::BakeJob(const BakeCommand& command, const Json& settings)
    : command_(command),
      kind_(wanted_kind(command.out, command.bits())),
      paths_(frame_paths(command.out, command.animation)),
      recipes_(recipes_of(command)),
      extras_{levels_asked(command.levels, command.level_rule, recipes_[0].atlas.size, kind_),
              normals_asked(command.normals, recipes_[0], command.out)},
      inputs_(files_read(command, recipes_[0])) {
    check();
    if (is_forward(command_)) std::for_each(recipes_.begin(), recipes_.end(), check_forward);
    made_from_ = what_it_is_made_from(settings);
}

std::vector<std::string> BakeJob::texture_outputs(std::uint32_t levels) const {
    std::vector<std::string> outputs;
    for (const std::string& path : paths_)
        for (std::string& file : output_paths(path, levels, extras_.has_normals()))
            outputs.push_back(std::move(file));
    return outputs;
}

std::vector<std::string> BakeJob::outputs(std::uint32_t levels) const {
    std::vector<std::string> outputs = texture_outputs(levels);
    for (const std::string& path : {command_.solid_map, command_.emitted_glsl})
        if (!path.empty()) outputs.push_back(path);
    return outputs;
}

/// Refuses outputs that would replace a file that is read or another output.
void BakeJob::check_files() const {
    CommandFiles files;
    files.read(inputs_);
    for (const std::string& path : texture_outputs(extras_.levels.count)) files.write(path);
    if (!command_.solid_map.empty()) files.write(command_.solid_map, ".exr");
    if (!command_.emitted_glsl.empty()) files.write(command_.emitted_glsl);
    if (!command_.report.empty() && command_.report != "-") files.write(command_.report);
    files.write(record_path(command_.out));
}

/// Everything that the command can be wrong about, before any work starts.
void BakeJob::check() const {
    if (command_.animation.asked() && holds_mesh(command_.out))
        throw Error(ExitCode::usage,
                    fmt::format("{}: --frames writes textures alone, .png or .exr; bake the mesh "
                                "once without --frames: its texture coordinates fit every frame",
                                command_.out));
    check_files();
    check_compress(command_.compress, recipes_[0].atlas.kind);
    if (command_.compress && extras_.has_normals())
        throw Error(ExitCode::usage,
                    "--compress: blocks alike in colour may differ in their normals; add --normals "
                    "none to leave the bumps out");
    check_idle();
}

/// Refuses what would change nothing.
void BakeJob::check_idle() const {
    const auto refuse = [&](std::string_view option, std::string_view why) {
        throw Error(ExitCode::usage, fmt::format("{}: {} does nothing: {}; leave it out",
                                                 command_.out, option, why));
    };
    const bool mesh = holds_mesh(command_.out), normals = extras_.has_normals();
    if (command_.depth && kind_ == ImageKind::rgb_float && !normals)
        refuse("--depth", "an .exr always has floats");
    if (command_.crease && !mesh && !normals) refuse("--crease", "a texture alone has no normals");
    const auto why_no_kernel = [kernel = kernel_named(command_.kernel)](const Recipe& recipe) {
        return idle_kernel(recipe, kernel);
    };
    if (std::ranges::find(recipes_, "", why_no_kernel) == recipes_.end())
        refuse("--kernel " + command_.kernel, why_no_kernel(recipes_[0]));
    if (!command_.pose.empty() && !mesh)
        refuse("--pose", "a texture alone is the same in all of them");
    if (command_.pose.empty()) refuse_edits(command_.recipe, {&idle_pose, 1});
    constexpr IdleKey still_pose{"pose", "frames are textures alone, which no pose changes"};
    refuse_moves(command_.animation.keys, {&still_pose, 1});
    check_edits(command_.recipe, recipes_[0], command_.animation.keys);
}

// OpenGL has the bits of the kernels that share theirs.
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
    if (synth == multipass_synth) return choose_multipass(multipass, platform, recipes_);
    const SynthesisChoice choice = synth == "host" || !any ? SynthesisChoice::host
                                   : synth == "gl"         ? SynthesisChoice::gl
                                                           : SynthesisChoice::automatic;
    return choose_synthesizer(choice, platform, recipes_);
}

Json BakeJob::what_it_is_made_from(const Json& settings) const {
    std::vector<std::string> files = files_of_mesh(command_.mesh, MeshFiles::read);
    if (is_pose_file(command_.pose))
        std::ranges::move(files_of_mesh(command_.pose, MeshFiles::read), std::back_inserter(files));
    std::ranges::move(images_of_recipe(command_.recipe.recipe, recipes_[0]),
                      std::back_inserter(files));
    Json made_from = {{"burl", burl_version()},
                      {"inputs", content_of(files, command_.recipe.images->digests())},
                      {"recipe", Json::parse(to_json(recipes_[0]))},
                      {"options", settings}};
    if (files.empty() || files[0] != command_.mesh) made_from["sample"] = command_.mesh;
    if (recipes_.size() > 1) {
        Sha256 hash;
        for (const Recipe& recipe : recipes_) hash.add(to_json(recipe));
        made_from["frames"] = hash.digest();
    }
    return made_from;
}

void BakeJob::set_up(Pipeline& pipeline, std::shared_ptr<TextureSynthesizer> synthesizer) const {
    pipeline.set_recipe(recipes_[0]);
    pipeline.set_threads(command_.threads);
    pipeline.set_kernel(kernel_named(command_.kernel));
    pipeline.set_forward(is_forward(command_));
    pipeline.set_synthesizer(std::move(synthesizer));
    pipeline.set_skips(command_.economy.skips());
    pipeline.set_cache(command_.economy.cache_bytes(paths_.size() > 1));
}

/// The pipeline's recipe as a texture in its file. Where it `releases`, the texels' points are gone
/// before the file is made, whose own buffers are as large.
BakeJob::Written BakeJob::write_texture(Pipeline& pipeline, const std::string& path,
                                        const MeshPose* pose, bool releases) const {
    if (kind_ == ImageKind::rgb_float && !command_.compress &&
        comes_in_bands(pipeline, extras_.levels))
        return write_bands(pipeline, path);
    BakedTexture texture = bake_texture(pipeline, kind_, extras_.levels);
    ExportOptions options;
    options.levels = std::move(texture.levels);
    Written written{compressed_bake(pipeline.atlas(), std::move(texture.image), command_.compress)};
    options.normals =
        bake_normals(pipeline, extras_.normals, command_.bits(), command_.crease_degrees());
    if (releases) pipeline.release_texels();
    const auto writing = Clock::now();
    options.crease_degrees = command_.crease_degrees();
    options.recipe_json = to_json(pipeline.recipe());
    options.recipe_name = pipeline.recipe().name;
    if (pose)
        options.pose = ExportPose{atlas_pose(*pose, pipeline.mesh(), pipeline.mesh_atlas()),
                                  pipeline.recipe().pose.weight};
    const BakedAtlas& baked = written.baked;
    written.files =
        scene_files(path, pipeline.atlas_mesh(), baked.packed ? *baked.packed : pipeline.atlas(),
                    baked.image, options);
    written.levels = options.levels.size();
    written.normals = std::move(options.normals);
    written.seconds = seconds_since(writing);
    return written;
}

/// The same of an .exr whose texture is never there as a whole.
BakeJob::Written BakeJob::write_bands(Pipeline& pipeline, const std::string& path) const {
    Written written;
    written.normals =
        bake_normals(pipeline, extras_.normals, command_.bits(), command_.crease_degrees());
    BandsWritten bands = write_exr_in_bands(pipeline, path, extras_.levels,
                                            written.normals ? &*written.normals : nullptr);
    written.levels = bands.levels;
    written.files = std::move(bands.files);
    written.seconds = bands.seconds;
    return written;
}

/// Adds the shader and the solid map where they are asked for; says what there is to know of the
/// map.
Json BakeJob::add_beside(std::vector<AtomicFile>& files, Pipeline& pipeline,
                         const std::string& shader) const {
    if (!command_.emitted_glsl.empty()) files.emplace_back(command_.emitted_glsl).write(shader);
    if (command_.solid_map.empty()) return {};
    auto [base, file] = write_solid_map(command_.solid_map, pipeline, command_.threads);
    files.push_back(std::move(file));
    return {{"file", command_.solid_map}, {"base", {base.x, base.y, base.z}}};
}

Json BakeJob::run(Pipeline& pipeline, std::shared_ptr<TextureSynthesizer> synthesizer,
                  double reading, LaterBake later) const {
    const auto start = Clock::now();
    for (const Recipe& recipe : recipes_) check_lattice(recipe, pipeline.mesh());
    const std::string shader = emitted_shader(command_, recipes_[0], pipeline.mesh());
    std::optional<MeshPose> pose;
    if (!command_.pose.empty())
        pose = load_pose(command_.mesh, command_.pose, command_.meshes.read);
    set_up(pipeline, synthesizer);
    lay_out(pipeline);
    if (later == LaterBake::none) pipeline.release_neighbours();
    const AtlasMetrics metrics = measure(pipeline.atlas_mesh(), pipeline.atlas(), pipeline.solid());
    if (pipeline.mesh().triangles.size() > many_triangles) return_freed_memory();
    const bool needed_later =
        later == LaterBake::atlas || !command_.solid_map.empty() || extras_.has_normals();
    Written written;
    std::vector<CommittedFile> committed;
    Json solid_map;
    double writing = 0.0;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
        if (i > 0) pipeline.set_recipe(recipes_[i]);
        written = {};  // two textures need not be held at a time
        written = write_texture(pipeline, paths_[i], pose ? &*pose : nullptr,
                                !needed_later && i + 1 == paths_.size());
        if (i + 1 == paths_.size()) solid_map = add_beside(written.files, pipeline, shader);
        const auto naming = Clock::now();
        std::ranges::move(commit_together(written.files), std::back_inserter(committed));
        writing += written.seconds + seconds_since(naming);
    }
    Json seconds = {{"read", reading}};
    seconds.update(times_json(pipeline.records()));
    seconds["write"] = writing;
    seconds["total"] = reading + seconds_since(start);
    Json normals;
    if (written.normals && wants_report())
        normals = normals_json(pipeline, *written.normals, command_.crease_degrees());
    const LevelsAsked levels{std::uint32_t(written.levels), extras_.levels.rule};
    const std::vector<std::string> files = outputs(levels.count);
    Json report =
        bake_json(command_.mesh, files, recipes_[0], pipeline, metrics, levels, std::move(seconds));
    if (written.baked.compressed) report["compressed"] = compress_json(written.baked);
    if (synthesizer) report["synthesis"] = synthesizer->report();
    if (!solid_map.empty()) report["solid_map"] = std::move(solid_map);
    if (!normals.empty()) report["normals"] = std::move(normals);
    if (!command_.animation.keys.empty()) report["animation"] = command_.animation.keys;
    write_record(command_.out, made_from_, committed, report);
    return report;
}

std::optional<Json> BakeJob::known_report() const {
    if (command_.force || !command_.economy.skips().allows(Skip::up_to_date)) return std::nullopt;
    std::optional<Json> report = report_if_up_to_date(command_.out, made_from_);
    if (!report) return report;
    // The folder may have been moved, or it is named from elsewhere.
    (*report)["input"] = command_.mesh;
    (*report)["outputs"] = outputs(report->at("mip_levels").get<std::uint32_t>());
    // Normals are measured for reports only.
    const bool lacks = extras_.has_normals() && !report->contains("normals");
    return lacks && wants_report() ? std::nullopt : report;
}

/// Whether that leaves a line for people to be said.
bool BakeJob::write_reports(const Json& report) const {
    if (!command_.report.empty()) write_json(command_.report, report);
    if (command_.json) write_json("-", report);
    return !command_.json && !command_.quiet && command_.report != "-";
}

void BakeJob::print_up_to_date(Json report) const {
    report["up_to_date"] = true;
    if (write_reports(report)) print_line(fmt::format("{}: up to date", paths_.front()));
}

void BakeJob::print(const Json& report) const {
    if (!write_reports(report)) return;
    print_summary(report, paths_);
    if (report.contains("compressed")) print_compressed(report["compressed"]);
}

}  // namespace burl
