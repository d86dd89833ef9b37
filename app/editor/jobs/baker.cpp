#include "app/editor/jobs/baker.h"

#include <bit>
#include <chrono>
#include <utility>

#include <tbb/parallel_invoke.h>

#include "app/editor/jobs/atlas.h"
#include "app/gl/draw/view_scene.h"
#include "app/pipeline/refinement.h"
#include "app/recipe/lattice_check.h"
#include "app/scene/unit_frame.h"

namespace burl {

namespace {

/// Size of the pipeline's cache of intermediate values, in bytes.
constexpr std::size_t cache_bytes = std::size_t(512) << 20;
constexpr double patience = 0.08;  // longest refinement step of a slider at rest, in seconds
constexpr std::uint32_t coarsest_side = 128;  ///< side of the coarsest level shown, in texels
constexpr double crease_degrees = 40.0;       // the default crease angle of `burl bake`

/// Returns the coarsest MIP level of a texture of `size` texels a side that still has coarsest_side
/// texels a side; 0 for smaller textures.
std::uint32_t coarsest_level(std::uint32_t size) {
    return size > coarsest_side ? std::uint32_t(std::bit_width(size / coarsest_side)) - 1 : 0;
}

std::shared_ptr<EditSurface> surface_of(const SceneParts& parts, const MeshPose* pose) {
    auto surface = std::make_shared<EditSurface>();
    surface->scene = baked_scene(parts, pose);
    surface->posed = pose != nullptr;
    const int normals = baked_material(surface->scene).normals;
    if (normals >= 0)  // a flat normal map stands in until one is baked
        surface->scene.textures[std::size_t(normals)].image = Image<Rgb8>(1, 1, {128, 128, 255});
    tbb::parallel_invoke(
        [&] { surface->unit_from_mesh = solid_from_mesh(*parts.input, SolidSpace::unit); },
        [&] { surface->sphere = bounding_sphere(surface->scene); },
        [&] { surface->frames = unit_frames(surface->scene); });
    surface->size = parts.atlas().options.size;
    surface->triangles = parts.input->triangles.size();
    surface->atlas = to_string(parts.atlas().options.kind);
    return surface;
}

std::shared_ptr<EditSurface> surface_of(Pipeline& pipeline, const MeshPose* pose) {
    return surface_of(scene_parts(pipeline, crease_degrees), pose);
}

/// Builds the picking structure of a surface, whose scene lives as long as the structure.
std::shared_ptr<const SurfacePick> pick_of(const std::shared_ptr<const EditSurface>& surface) {
    return std::make_shared<const SurfacePick>(
        std::shared_ptr<const Scene>(surface, &surface->scene));
}

/// Whether the recipes differ in paint at most: the pipeline then still has the unpainted texture.
bool only_paint_differs(Recipe before, const Recipe& now) {
    before.paint = now.paint;
    return before == now;
}

}  // namespace

EditBaker::EditBaker(std::function<void()> wake, double budget)
    : wake_(wake),
      budget_(budget),
      worker_([this](const WorkerRequest& request,
                     const std::stop_token& stop) { work(request, stop); },
              std::move(wake)) {}

/// The job queue ends before any member is destroyed: its jobs call the worker, and the worker
/// queues jobs.
EditBaker::~EditBaker() {
    errands_.end();
}

void EditBaker::set_mesh(Mesh mesh) {
    const std::scoped_lock lock(mutex_);
    next_mesh_ = std::move(mesh);
    next_pose_ = nullptr;
    unseen_ = true;
}

void EditBaker::set_pose(std::shared_ptr<const MeshPose> pose) {
    const std::scoped_lock lock(mutex_);
    next_pose_ = std::move(pose);
}

std::shared_ptr<const EditSurface> EditBaker::surface() const {
    const std::scoped_lock lock(mutex_);
    return surface_;
}

std::shared_ptr<const EditSurface> EditBaker::coming() const {
    const std::scoped_lock lock(mutex_);
    return coming_;
}

bool EditBaker::opening() const {
    if (worker_.idle()) return false;
    const std::scoped_lock lock(mutex_);
    return unseen_;
}

std::shared_ptr<const EditPicture> EditBaker::picture() const {
    const std::scoped_lock lock(mutex_);
    return picture_;
}

std::shared_ptr<const SurfacePick> EditBaker::pick() const {
    const std::scoped_lock lock(mutex_);
    return pick_;
}

bool EditBaker::want_sheet(bool wanted) {
    const std::scoped_lock lock(mutex_);
    const bool begins = wanted && !wants_sheet_;
    wants_sheet_ = wanted;
    if (!wanted) sheet_.reset();
    return begins;
}

std::shared_ptr<const AtlasSheet> EditBaker::sheet() const {
    const std::scoped_lock lock(mutex_);
    return surface_ && sheet_key_.surface == surface_->number ? sheet_ : nullptr;
}

StageRecords EditBaker::records() const {
    const std::scoped_lock lock(mutex_);
    return records_;
}

bool EditBaker::laying_out() const {
    const std::scoped_lock lock(mutex_);
    return begun_ && !errands_.idle();
}

void EditBaker::wait() const {
    do {
        worker_.wait();
        errands_.wait();
    } while (!idle());
}

std::optional<std::string> EditBaker::take_problem() {
    if (auto problem = worker_.take_problem()) return problem;
    const std::scoped_lock lock(mutex_);
    return std::exchange(problem_, std::nullopt);
}

/// Takes over the mesh and the pose set since the last request. Returns whether the pose changed.
bool EditBaker::take_mesh() {
    std::optional<Mesh> mesh;
    std::optional<std::shared_ptr<const MeshPose>> pose;
    {
        const std::scoped_lock lock(mutex_);
        mesh = std::exchange(next_mesh_, std::nullopt);
        pose = std::exchange(next_pose_, std::nullopt);
    }
    if (mesh) {
        pipeline_ = std::make_unique<Pipeline>(std::move(*mesh));
        pipeline_->set_cache(cache_bytes);
        fresh_ = true;
        ++mesh_;
        errands_.cancel();
        laid_out_.reset();
        finest_.reset();
    }
    if (!pose || *pose == pose_) return false;
    take_pose(std::move(*pose));
    return true;
}

void EditBaker::take_pose(std::shared_ptr<const MeshPose> pose) {
    pose_ = std::move(pose);
    const std::size_t corners = pipeline_ ? 3 * pipeline_->mesh().triangles.size() : 0;
    if (!pose_ || pose_->positions.size() == corners) return;
    pose_.reset();
    const std::scoped_lock lock(mutex_);
    problem_ = "the pose is of a mesh with other triangles: a file has changed";
}

/// Announces a surface, which publish_picture() will show together with its first picture.
void EditBaker::announce(std::shared_ptr<EditSurface> surface) {
    {
        const std::scoped_lock lock(mutex_);
        surface->number = ++numbers_;
        coming_ = surface;
    }
    pending_ = std::move(surface);
    wake_();
}

/// Takes over an atlas that was laid out in the background. Returns the atlas to show: `wanted`
/// where it is laid out, otherwise atlas_at_once().
AtlasOptions EditBaker::take_atlas(const AtlasOptions& wanted) {
    std::optional<OwnAtlas> own;
    {
        const std::scoped_lock lock(mutex_);
        own = std::exchange(own_, std::nullopt);
        if (own && begun_ == own->pipeline->recipe().atlas) begun_.reset();
    }
    if (own && own->mesh == mesh_ && own->pipeline->recipe().atlas == wanted) {
        pipeline_ = std::move(own->pipeline);
        if (own->pose != pose_) {
            own->surface = surface_of(*pipeline_, pose_.get());
            own->pick = pick_of(own->surface);
        }
        announce(std::move(own->surface));
        pending_pick_ = std::move(own->pick);
        shown_bumps_ = !pipeline_->recipe().bump.empty();
        laid_out_ = shown_atlas_ = wanted;
        finest_.reset();
    }
    if (laid_out_ == wanted) return wanted;
    laid_out_.reset();
    return atlas_at_once(wanted, pipeline_->mesh().triangles.size());
}

/// Queues a job that lays out the recipe's own atlas, unless one is queued or running.
void EditBaker::begin_atlas(const Recipe& recipe) {
    {
        const std::scoped_lock lock(mutex_);
        if (begun_ == recipe.atlas) return;
        begun_ = recipe.atlas;
    }
    auto pipeline = std::make_unique<Pipeline>(pipeline_->mesh());
    pipeline->set_cache(cache_bytes);
    pipeline->set_recipe(recipe);
    // std::function copies its closure, and std::unique_ptr cannot be copied.
    errands_.add([this, mesh = mesh_, pose = pose_,
                  held = std::make_shared<std::unique_ptr<Pipeline>>(std::move(pipeline))](
                     const std::stop_token& stop) { lay_out(mesh, pose, std::move(*held), stop); });
}

void EditBaker::lay_out(std::uint64_t mesh, const std::shared_ptr<const MeshPose>& pose,
                        std::unique_ptr<Pipeline> pipeline, const std::stop_token& stop) {
    try {
        if (!lay_out_aside(*pipeline, stop)) return;
        std::shared_ptr<EditSurface> surface = surface_of(*pipeline, pose.get());
        std::shared_ptr<const SurfacePick> pick = pick_of(surface);
        const std::scoped_lock lock(mutex_);
        own_ = OwnAtlas{mesh, std::move(pipeline), pose, std::move(surface), std::move(pick)};
    } catch (const std::exception& problem) {
        const std::scoped_lock lock(mutex_);
        problem_ = problem.what();
    }
    worker_.again();
}

/// Publishes the newest picture again, with the normal map of the recipe's bumps.
void EditBaker::publish_normals() {
    auto normals =
        std::make_shared<const Image<Rgb8>>(pipeline_->normal_map<Rgb8>(crease_degrees, true));
    if (normals_ && *normals == *normals_) return;
    normals_ = std::move(normals);
    {
        const std::scoped_lock lock(mutex_);
        auto picture = std::make_shared<EditPicture>(*picture_);
        picture->number = ++numbers_;
        picture->normals = normals_;
        picture_ = std::move(picture);
        records_ = pipeline_->records();
    }
    wake_();
}

/// Publishes the picking structure of a surface, on the job queue's thread, once per surface.
void EditBaker::publish_pick(const std::shared_ptr<const EditSurface>& surface) {
    std::shared_ptr<const SurfacePick> pick = pick_of(surface);
    {
        const std::scoped_lock lock(mutex_);
        if (surface_ != surface) return;
        pick_ = std::move(pick);
    }
    wake_();
}

/// Publishes the sheet of the surface shown, if a window shows sheets and the sheet is outdated.
void EditBaker::publish_sheet() {
    SheetKey key{0, pipeline_->recipe().solid.space};
    {
        const std::scoped_lock lock(mutex_);
        if (!surface_ || pending_) return;  // the pipeline already has the next surface's atlas
        key.surface = surface_->number;
        if (!wants_sheet_ || (sheet_ && sheet_key_ == key)) return;
    }
    auto sheet = std::make_shared<const AtlasSheet>(atlas_sheet(*pipeline_));
    {
        const std::scoped_lock lock(mutex_);
        sheet_ = std::move(sheet);
        sheet_key_ = key;
    }
    wake_();
}

void EditBaker::publish_picture(const WorkerRequest& request, std::uint32_t level,
                                const Image<Rgb8>& texels, double seconds) {
    auto picture = std::make_shared<EditPicture>();
    picture->request = request.number;
    picture->level = level;
    picture->texels = texels;
    picture->levels = make_levels_(texels);
    picture->seconds = seconds;
    picture->normals = normals_;
    {
        const std::scoped_lock lock(mutex_);
        if (level == 0 && !next_mesh_) unseen_ = false;
        if (pending_) {
            surface_ = std::exchange(pending_, nullptr);
            coming_.reset();
            if (pending_pick_) pick_ = std::exchange(pending_pick_, nullptr);
        }
        picture->number = ++numbers_;
        picture->surface = surface_->number;
        picture_ = std::move(picture);
        records_ = pipeline_->records();
    }
    wake_();
}

/// Queues a new surface's jobs: building its picking structure, and laying out a better atlas.
void EditBaker::give_errands(const Recipe& recipe, bool moving) {
    const std::shared_ptr<const EditSurface> shown = surface();
    if (!shown) return;
    if (errands_of_ != shown->number) {
        errands_of_ = shown->number;
        const std::shared_ptr<const SurfacePick> found = pick();
        // The structure was built with the background atlas.
        if (found && &found->scene() == &shown->scene) return;
        errands_.cancel();
        {
            const std::scoped_lock lock(mutex_);
            begun_.reset();
        }
        errands_.add([this, shown](const std::stop_token&) { publish_pick(shown); });
    }
    if (shown_atlas_ != recipe.atlas && !moving) begin_atlas(recipe);
}

void EditBaker::work(const WorkerRequest& request, const std::stop_token& stop) {
    const bool posed = take_mesh();
    if (!pipeline_) return;
    check_lattice(request.recipe, pipeline_->mesh());
    Recipe recipe = request.recipe;
    recipe.atlas = take_atlas(request.recipe.atlas);
    const bool better = pending_pick_ != nullptr;
    pipeline_->set_recipe(recipe);
    if (better) normals_.reset();
    const bool other =
        fresh_ || shown_atlas_ != recipe.atlas || shown_bumps_ == recipe.bump.empty();
    if (other || (posed && !better)) {
        const SceneParts parts = scene_parts(*pipeline_, crease_degrees);
        tbb::parallel_invoke([&] { announce(surface_of(parts, pose_.get())); },
                             [&] { pipeline_->solid(); });
        pending_pick_.reset();
    }
    if (other) {
        normals_.reset();
        shown_bumps_ = !recipe.bump.empty();
        shown_atlas_ = recipe.atlas;
        choice_.emplace(budget_, coarsest_level(recipe.atlas.size));
        fresh_ = false;
    }
    auto start = std::chrono::steady_clock::now();
    const SliderState slider = request.moving ? SliderState::moving : SliderState::released;
    // With only paint changed, level 0 is quicker than a coarser level, its time says nothing about
    // level choice, and the sharp texture on screen need not become blurred first.
    LevelChoice finest(budget_, 0);
    const bool whole = better || (finest_ && only_paint_differs(*finest_, recipe));
    const bool done =
        refine<Rgb8>(*pipeline_, whole ? finest : *choice_, slider, patience, stop,
                     [&](std::uint32_t level, const Image<Rgb8>& texels) {
                         const auto now = std::chrono::steady_clock::now();
                         if (level == 0) finest_ = recipe;
                         publish_picture(request, level, texels,
                                         std::chrono::duration<double>(now - start).count());
                         start = std::chrono::steady_clock::now();
                     });
    if (done && !request.moving && shown_bumps_) publish_normals();
    give_errands(request.recipe, request.moving);
    publish_sheet();
}

}  // namespace burl
