#include "app/edit_export.h"

#include <fmt/format.h>

#include <exception>
#include <utility>

#include "app/bake_normals.h"
#include "app/export.h"
#include "app/lattice_check.h"
#include "app/pipeline.h"
#include "app/sample_meshes.h"
#include "atlas/mesh_io.h"

namespace burl {

namespace {

BakedImage texture_of(Pipeline& pipeline, ImageKind kind) {
    if (kind == ImageKind::rgb_float) return pipeline.synthesize<RgbF>();
    if (kind == ImageKind::rgb16) return pipeline.synthesize<Rgb16>();
    return pipeline.synthesize<Rgb8>();
}

}  // namespace

Mesh load_mesh(const std::string& path) {
    return is_sample_mesh(path) ? sample_mesh(path) : read_mesh(path);
}

void bake_file(const std::string& mesh_path, const Recipe& recipe, const std::string& out_path) {
    constexpr int depth = 8;
    ExportOptions options;
    const NormalSpace normals = normals_asked("", recipe, out_path);
    check_output(out_path, mesh_path, 0, normals != NormalSpace::none);
    Pipeline pipeline(load_mesh(mesh_path));
    check_lattice(recipe, pipeline.mesh());
    pipeline.set_recipe(recipe);
    const BakedImage texture = texture_of(pipeline, wanted_kind(out_path, depth));
    options.normals = bake_normals(pipeline, normals, depth, options.crease_degrees);
    options.recipe_json = to_json(recipe);
    export_scene(out_path, pipeline.atlas_mesh(), pipeline.atlas(), texture, options);
}

void EditExport::start(std::string mesh_path, Recipe recipe, std::string out_path) {
    wait();
    {
        const std::scoped_lock lock(mutex_);
        busy_ = true;
    }
    thread_ = std::jthread([this, mesh = std::move(mesh_path), what = std::move(recipe),
                            out = std::move(out_path)] { run(mesh, what, out); });
}

void EditExport::run(const std::string& mesh_path, const Recipe& recipe,
                     const std::string& out_path) {
    Outcome outcome{false, fmt::format("exported {}", out_path)};
    try {
        bake_file(mesh_path, recipe, out_path);
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
