#include "app/editor/jobs/atlas.h"

#include <algorithm>
#include <bit>
#include <exception>
#include <utility>

#include <tbb/task_arena.h>

#include "app/base/out_of_memory.h"
#include "app/gl/draw/view_scene.h"

namespace burl {

namespace {

/// Lays out the atlas of the pipeline's recipe and makes its texels' solid points; false where
/// `stop` was requested first.
bool lay_out_aside(Pipeline& pipeline, const std::stop_token& stop) {
    const int cores = tbb::this_task_arena::max_concurrency();
    tbb::task_arena aside(std::max(1, cores - 1), 1, tbb::task_arena::priority::low);
    return aside.execute([&] {
        if (!pipeline.lay_out(stop)) return false;
        pipeline.solid();
        return !stop.stop_requested();
    });
}

}  // namespace

AtlasOptions atlas_at_once(const AtlasOptions& wanted, std::size_t triangles) {
    AtlasOptions quick = wanted;
    const bool slow = wanted.kind == AtlasKind::patch || wanted.kind == AtlasKind::chart;
    if (!slow || triangles <= many_faces || wanted.size == 0) return quick;
    quick.kind = AtlasKind::quad;
    quick.size = std::bit_floor(wanted.size);
    return quick;
}

std::unique_ptr<Pipeline> make_edit_pipeline(Mesh mesh) {
    auto pipeline = std::make_unique<Pipeline>(std::move(mesh));
    pipeline->set_cache(std::size_t(512) << 20);
    return pipeline;
}

void BackgroundAtlas::begin(const Mesh& mesh, std::uint64_t number,
                            std::shared_ptr<const MeshPose> pose, const Recipe& recipe) {
    {
        const std::scoped_lock lock(mutex_);
        if (begun_ == recipe.atlas) return;
        begun_ = recipe.atlas;
    }
    // std::function copies its closure, and a result cannot be copied.
    auto result =
        std::make_shared<Result>(Result{number, make_edit_pipeline(mesh), std::move(pose)});
    result->pipeline->set_recipe(recipe);
    jobs_.add([this, result](const std::stop_token& stop) { lay_out(std::move(*result), stop); });
}

void BackgroundAtlas::lay_out(Result result, const std::stop_token& stop) {
    std::string problem;
    try {
        if (!lay_out_aside(*result.pipeline, stop)) return;
        result.surface =
            edit_surface(scene_parts(*result.pipeline, edit_crease_degrees), result.pose.get());
        result.pick = pick_of(result.surface);
        const std::scoped_lock lock(mutex_);
        result_ = std::move(result);
    } catch (const std::exception& error) {
        problem = words_of(error);
    }
    ended_(problem);
}

bool BackgroundAtlas::busy() const {
    const std::scoped_lock lock(mutex_);
    return begun_ && !jobs_.idle();
}

std::optional<BackgroundAtlas::Result> BackgroundAtlas::take() {
    const std::scoped_lock lock(mutex_);
    auto result = std::exchange(result_, std::nullopt);
    if (result && begun_ == result->pipeline->recipe().atlas) begun_.reset();
    return result;
}

void BackgroundAtlas::forget() {
    const std::scoped_lock lock(mutex_);
    begun_.reset();
}

}  // namespace burl
