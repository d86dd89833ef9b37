#include "app/editor/work/export.h"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <utility>

#include "app/bake/normals.h"
#include "app/bake/texture.h"
#include "app/base/atomic_file.h"
#include "app/editor/work/reader.h"
#include "app/export/command_files.h"
#include "app/export/emit.h"
#include "app/export/export.h"
#include "app/options/animation.h"
#include "app/recipe/keyed_recipe.h"
#include "app/recipe/lattice_check.h"
#include "app/surface/load_pose.h"
#include "atlas/base/error.h"
#include "atlas/build/atlas_pose.h"

namespace burl {

namespace {

/// Writes the recipe as a fragment shader after the checks of `burl bake --emit-glsl`.
void write_shader(const ExportRequest& request) {
    const Mesh mesh = load_mesh(request.mesh);
    check_lattice(request.recipe, mesh);
    write_file(request.out, emit_glsl(request.recipe, texture_from_mesh(request.recipe, mesh)));
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
    return output_paths(out, levels, normals != NormalSpace::none);
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
    return files_of_texture(request, request.out, export_levels(request).count);
}

/// Throws Error where an output file is also an input.
void check_outputs(const ExportRequest& request) {
    CommandFiles files;
    files.read(files_of_mesh(request.mesh));
    if (is_pose_file(request.pose)) files.read(files_of_mesh(request.pose));
    files.read(files_of_recipe(request.recipe_path, request.recipe));
    for (const std::string& file : written_files(request)) files.write(file);
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
    return options;
}

std::vector<std::string> export_files(const ExportRequest& request) {
    try {
        return written_files(request);
    } catch (const Error&) {
        return {request.out};
    }
}

void bake_file(const ExportRequest& request) {
    check_outputs(request);
    if (is_shader_file(request.out)) return write_shader(request);
    const Recipe& recipe = request.recipe;
    const ImageKind kind = wanted_kind(request.out, export_depth);
    const LevelsAsked levels = export_levels(request);
    const NormalSpace normals = normals_asked("", recipe, request.out);
    Pipeline pipeline(load_mesh(request.mesh));
    check_lattice(recipe, pipeline.mesh());
    pipeline.set_recipe(recipe);
    BakedTexture texture = bake_texture(pipeline, kind, levels);
    ExportOptions options;
    options.levels = std::move(texture.levels);
    options.normals = bake_normals(pipeline, normals, export_depth, options.crease_degrees);
    options.recipe_json = to_json(recipe);
    options.recipe_name = recipe.name;
    if (!request.pose.empty() && holds_mesh(request.out))
        options.pose = ExportPose{atlas_pose(load_pose(request.mesh, request.pose), pipeline.mesh(),
                                             pipeline.mesh_atlas()),
                                  recipe.pose.weight};
    export_scene(request.out, pipeline.atlas_mesh(), pipeline.atlas(), texture.image, options);
}

void bake_frames(const ExportRequest& request) {
    if (holds_mesh(request.out) || is_shader_file(request.out))
        throw Error(ExitCode::usage,
                    fmt::format("{}: frames are textures alone, .png or .exr", request.out));
    check_outputs(request);
    constexpr std::size_t cache_bytes = std::size_t(512) << 20;
    const KeyedAnimation& animation = request.recipe.animation;
    const int frames = frame_count(animation);
    Pipeline pipeline(load_mesh(request.mesh));
    pipeline.set_cache(cache_bytes);
    for (int i = 0; i < frames; ++i) {
        const Recipe still = recipe_at(request.recipe, frame_seconds(animation, i, frames));
        const std::string path = frame_path(request.out, std::size_t(i) + 1);
        const NormalSpace normals = normals_asked("", still, path);
        check_lattice(still, pipeline.mesh());
        pipeline.set_recipe(still);
        const BakedTexture texture = bake_texture(pipeline, wanted_kind(path, export_depth), {});
        ExportOptions options;
        options.normals = bake_normals(pipeline, normals, export_depth, options.crease_degrees);
        options.recipe_json = to_json(still);
        export_scene(path, pipeline.atlas_mesh(), pipeline.atlas(), texture.image, options);
    }
}

void EditExport::start(ExportRequest request) {
    wait();
    {
        const std::scoped_lock lock(mutex_);
        busy_ = true;
    }
    thread_ = std::jthread([this, what = std::move(request)] { run(what); });
}

void EditExport::run(const ExportRequest& request) {
    Outcome outcome{false, fmt::format("exported {}", request.out)};
    try {
        const bool moves = !request.recipe.animation.tracks.empty();
        (moves ? bake_frames : bake_file)(request);
    } catch (const std::exception& problem) {
        outcome = {true, problem.what()};
    }
    {
        const std::scoped_lock lock(mutex_);
        outcome_ = std::move(outcome);
        busy_ = false;
    }
    wake_();
}

bool EditExport::busy() const {
    const std::scoped_lock lock(mutex_);
    return busy_;
}

void EditExport::wait() {
    if (thread_.joinable()) thread_.join();
}

std::optional<EditExport::Outcome> EditExport::take_outcome() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(outcome_, std::nullopt);
}

}  // namespace burl
