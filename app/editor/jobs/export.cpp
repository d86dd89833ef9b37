#include "app/editor/jobs/export.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <filesystem>
#include <utility>

#include "app/bake/bake.h"
#include "app/base/atomic_file.h"
#include "app/base/out_of_memory.h"
#include "app/editor/jobs/open_files.h"
#include "app/export/command_files.h"
#include "app/export/emit.h"
#include "app/export/formats.h"
#include "app/options/animation.h"
#include "app/pipeline/tasks.h"
#include "app/recipe/edit/keyed_recipe.h"
#include "app/recipe/lattice_check.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

/// Writes the recipe as a fragment shader after the checks of `burl bake --emit-glsl`.
void write_shader(const ExportRequest& request) {
    const Mesh mesh = load_mesh(request.mesh);
    check_lattice(request.recipe, mesh);
    const Affine3 solid = solid_from_mesh(mesh, request.recipe.solid.space);
    write_file(request.out, emit_glsl(request.recipe, solid).text);
}

constexpr int export_depth = 8;

LevelsAsked export_levels(const ExportRequest& request) {
    return levels_asked(request.levels ? "all" : "", "", request.recipe.atlas.size,
                        wanted_kind(request.out, export_depth));
}

/// Returns the paths of all files of one texture: its MIP levels and its normal map.
std::vector<std::string> files_of_texture(const ExportRequest& request, const std::string& out,
                                          std::uint32_t levels) {
    const NormalSpace normals = normals_asked("", request.recipe, out);
    const MaterialAsked asked{packing_asked("", out), export_depth, levels,
                              normals == NormalSpace::tangent};
    return output_paths(out, levels, normals != NormalSpace::none,
                        picture_names({&request.recipe, 1}, asked), asked.rough_levels());
}

std::vector<std::string> files_of_frames(const ExportRequest& request) {
    std::vector<std::string> files;
    const int frames = frame_count(request.recipe.animation);
    for (int i = 0; i < frames; ++i) {
        const std::string out = frame_path(request.out, std::size_t(i) + 1);
        for (std::string& file : files_of_texture(request, out, 0))
            files.push_back(std::move(file));
    }
    return files;
}

std::vector<std::string> written_files(const ExportRequest& request) {
    if (is_shader_file(request.out)) return {request.out};
    if (!request.recipe.animation.tracks.empty()) return files_of_frames(request);
    std::vector<std::string> files =
        files_of_texture(request, request.out, export_levels(request).count);
    for (const std::string& mask : request.masks)
        files.push_back(picture_path(request.out, mask, coding_asked("", request.out).format));
    return files;
}

/// Throws Error where an output file is also an input.
void check_outputs(const ExportRequest& request) {
    CommandFiles files;
    files.read(files_of_mesh(request.mesh));
    if (is_pose_file(request.pose)) files.read(files_of_mesh(request.pose));
    files.read(files_of_recipe(request.recipe_path, request.recipe));
    for (const std::string& file : written_files(request)) files.write(file);
}

/// The plan by which `burl bake` with bake_options() writes the same files.
BakePlan plan_of(const ExportRequest& request) {
    BakePlan plan;
    plan.kind = wanted_kind(request.out, export_depth);
    plan.coding = coding_asked("", request.out);
    plan.depth = export_depth;
    plan.levels = export_levels(request);
    plan.normals = normals_asked("", request.recipe, request.out);
    plan.packing = packing_asked("", request.out);
    plan.recipe = [&request](std::size_t) { return request.recipe; };
    plan.paths = {request.out};
    plan.channels = request.masks;
    plan.measures = false;
    return plan;
}

/// A plan's files, made and written unless a stop is requested.
struct PlannedExport {
    BakePlan plan{};
    std::size_t cache = 0;  ///< bytes of the pipeline's cache
};

void bake_plan(const ExportRequest& request, PlannedExport planned, const std::stop_token& stop,
               Course* told) {
    BakePlan& plan = planned.plan;
    plan.stop = stop;
    plan.told = told;
    if (told) told->begin_item("", 0, 1, tasks::read);
    Pipeline pipeline(load_mesh(request.mesh));
    check_lattice(plan.recipe(0), pipeline.mesh());
    std::optional<MeshPose> pose;
    if (!request.pose.empty() && holds_mesh(request.out))
        pose = load_pose(request.mesh, request.pose);
    pipeline.set_cache(planned.cache);
    if (!pose && keeps_document(request.mesh, request.out)) {
        plan.kept = kept_scene(request.mesh);
        prepare(*plan.kept, request.mesh, {}, request.out);
    }
    if (is_obj(request.out)) plan.obj = kept_obj(request.mesh, pipeline.mesh(), {});
    bake(pipeline, plan, pose ? &*pose : nullptr);
}

}  // namespace

bool is_shader_file(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    return extension == ".frag" || extension == ".glsl";
}

std::vector<std::string> bake_options(const ExportRequest& request) {
    if (is_shader_file(request.out)) {
        const auto beside = std::filesystem::path(request.out).replace_extension(".glb");
        return {"-o", beside.string(), "--emit-glsl", request.out};
    }
    std::vector<std::string> options{"-o", request.out};
    const KeyedAnimation& animation = request.recipe.animation;
    if (!animation.tracks.empty())
        options.insert(options.end(), {"--frames", fmt::format("{}", frame_count(animation))});
    if (request.levels) options.insert(options.end(), {"--levels", "all"});
    if (!request.masks.empty())
        options.insert(options.end(),
                       {"--channels", fmt::format("{}", fmt::join(request.masks, ","))});
    return options;
}

std::vector<std::string> export_files(const ExportRequest& request) {
    try {
        return written_files(request);
    } catch (const Error&) {
        return {request.out};
    }
}

void bake_file(const ExportRequest& request, const std::stop_token& stop, Course* told) {
    check_outputs(request);
    if (is_shader_file(request.out)) return write_shader(request);
    bake_plan(request, {plan_of(request)}, stop, told);
}

void bake_frames(const ExportRequest& request, const std::stop_token& stop, Course* told) {
    if (holds_mesh(request.out) || is_shader_file(request.out))
        throw Error(
            ExitCode::usage,
            fmt::format("{}: frames are textures alone, such as .png or .exr", request.out));
    check_outputs(request);
    constexpr std::size_t cache = std::size_t(512) << 20;
    const KeyedAnimation& animation = request.recipe.animation;
    const int frames = frame_count(animation);
    BakePlan plan = plan_of(request);
    plan.levels = {};
    plan.recipe = [&](std::size_t number) {
        return recipe_at(request.recipe, frame_seconds(animation, int(number), frames));
    };
    plan.paths.clear();
    for (int i = 0; i < frames; ++i)
        plan.paths.push_back(frame_path(request.out, std::size_t(i) + 1));
    bake_plan(request, {std::move(plan), cache}, stop, told);
}

void EditExport::start(ExportRequest request) {
    wait();
    {
        const std::scoped_lock lock(mutex_);
        busy_ = true;
        course_ = std::make_shared<Course>();
    }
    thread_ = std::jthread(
        [this, what = std::move(request)](const std::stop_token& stop) { run(what, stop); });
}

void EditExport::run(const ExportRequest& request, const std::stop_token& stop) {
    Outcome outcome{false, fmt::format("exported {}", request.out)};
    try {
        const std::jthread waker([this](const std::stop_token& done) { wake_until(done); });
        const bool moves = !request.recipe.animation.tracks.empty();
        (moves ? bake_frames : bake_file)(request, stop, course_.get());
    } catch (const std::exception& problem) {
        outcome = {true, words_of(problem)};
    }
    {
        const std::scoped_lock lock(mutex_);
        outcome_ = std::move(outcome);
        busy_ = false;
    }
    wake_();
}

/// Wakes the window ten times a second, which shows how far the export is.
void EditExport::wake_until(const std::stop_token& done) {
    constexpr std::chrono::milliseconds period{100};
    std::mutex mutex;
    std::condition_variable_any changed;
    std::unique_lock lock(mutex);
    while (!done.stop_requested()) {
        changed.wait_for(lock, done, period, [] { return false; });
        wake_();
    }
}

bool EditExport::busy() const {
    const std::scoped_lock lock(mutex_);
    return busy_;
}

ProgressState EditExport::progress() const {
    const std::scoped_lock lock(mutex_);
    return course_ ? course_->state() : ProgressState();
}

void EditExport::wait() {
    if (thread_.joinable()) thread_.join();
}

std::optional<EditExport::Outcome> EditExport::take_outcome() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(outcome_, std::nullopt);
}

}  // namespace burl
