#include "app/editor/jobs/baker.h"

#include <bit>
#include <chrono>
#include <utility>

#include <tbb/parallel_invoke.h>

#include "app/editor/jobs/material.h"
#include "app/gl/draw/view_scene.h"
#include "app/pipeline/refinement.h"
#include "app/recipe/lattice_check.h"
#include "app/scene/scene.h"

namespace burl {

namespace {

constexpr double patience = 0.08;  // longest refinement step of a slider at rest, in seconds
constexpr std::uint32_t coarsest_side = 128;  ///< side of the coarsest level shown, in texels

/// Returns the coarsest MIP level of a texture of `size` texels a side that still has coarsest_side
/// texels a side; 0 for smaller textures.
std::uint32_t coarsest_level(std::uint32_t size) {
    return size > coarsest_side ? std::uint32_t(std::bit_width(size / coarsest_side)) - 1 : 0;
}

/// Whether the recipes differ in paint over the texture at most: the pipeline then still has the
/// unpainted texture.
bool only_paint_differs(Recipe before, const Recipe& now) {
    if (mask_strokes(before.paint) != mask_strokes(now.paint)) return false;
    before.paint = now.paint;
    return before == now;
}

}  // namespace

EditBaker::EditBaker(std::function<void()> wake, double budget)
    : wake_(wake),
      budget_(budget),
      own_atlas_(jobs_,
                 [this](const std::string& problem) {
                     if (!problem.empty()) report(problem);
                     worker_.again();
                 }),
      worker_([this](const WorkerRequest& request,
                     const std::stop_token& stop) { work(request, stop); },
              std::move(wake)) {}

/// The job queue ends before any member is destroyed: its jobs call the worker, and the worker
/// queues jobs.
EditBaker::~EditBaker() {
    jobs_.end();
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

bool EditBaker::opening() const {
    if (worker_.idle()) return false;
    const std::scoped_lock lock(mutex_);
    return unseen_;
}

void EditBaker::wait() const {
    do {
        worker_.wait();
        jobs_.wait();
    } while (!idle());
}

std::optional<std::string> EditBaker::take_problem() {
    if (auto problem = worker_.take_problem()) return problem;
    const std::scoped_lock lock(mutex_);
    return std::exchange(problem_, std::nullopt);
}

void EditBaker::report(std::string problem) {
    const std::scoped_lock lock(mutex_);
    problem_ = std::move(problem);
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
        synthesizer_.forget_atlas();
        pipeline_ = make_edit_pipeline(std::move(*mesh));
        fresh_ = true;
        ++mesh_;
        jobs_.cancel();
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
    report("the pose is of a mesh with other triangles: a file has changed");
}

/// Takes over an atlas that was laid out in the background. Returns the atlas to show: `wanted`
/// where it is laid out, otherwise atlas_at_once().
AtlasOptions EditBaker::take_atlas(const AtlasOptions& wanted) {
    std::optional<BackgroundAtlas::Result> own = own_atlas_.take();
    if (own && own->mesh == mesh_ && own->pipeline->recipe().atlas == wanted) {
        synthesizer_.forget_atlas();
        pipeline_ = std::move(own->pipeline);
        if (own->pose != pose_) {
            own->surface = edit_surface(scene_parts(*pipeline_, edit_crease_degrees), pose_.get());
            own->pick = pick_of(own->surface);
        }
        front_.announce(std::move(own->surface), std::move(own->pick));
        wake_();
        shown_bumps_ = !pipeline_->recipe().bump.empty();
        shown_maps_ = scene_material(pipeline_->recipe()).maps;
        laid_out_ = shown_atlas_ = wanted;
        finest_.reset();
    }
    if (laid_out_ == wanted) return wanted;
    laid_out_.reset();
    return atlas_at_once(wanted, pipeline_->mesh().triangles.size());
}

/// Announces another surface where the mesh, its atlas, its pose (`posed`) or which pictures its
/// material has changed since the last one.
void EditBaker::renew_surface(const Recipe& recipe, bool posed) {
    const SceneMaterial material = scene_material(recipe);
    const bool other = fresh_ || shown_atlas_ != recipe.atlas ||
                       shown_bumps_ == recipe.bump.empty() || shown_maps_ != material.maps;
    if (other || posed) {
        const SceneParts parts = scene_parts(*pipeline_, edit_crease_degrees);
        tbb::parallel_invoke(
            [&] {
                front_.announce(edit_surface(parts, pose_.get()));
                wake_();
            },
            [&] { pipeline_->solid(); });
    }
    if (!other) return;
    normals_.reset();
    shown_bumps_ = !recipe.bump.empty();
    shown_atlas_ = recipe.atlas;
    shown_maps_ = material.maps;
    choice_.emplace(budget_, coarsest_level(recipe.atlas.size));
    fresh_ = false;
}

void EditBaker::publish(EditPicture picture) {
    const bool finest = picture.level == 0;
    front_.publish(std::move(picture), pipeline_->records());
    if (finest) {
        const std::scoped_lock lock(mutex_);
        if (!next_mesh_) unseen_ = false;
    }
    wake_();
}

/// Publishes the newest picture again, with the normal map of the recipe's bumps.
void EditBaker::publish_normals() {
    auto normals =
        std::make_shared<const Image<Rgb8>>(pipeline_->normal_map<Rgb8>(edit_crease_degrees, true));
    if (normals_ && *normals == *normals_) return;
    normals_ = std::move(normals);
    front_.publish(normals_, pipeline_->records());
    wake_();
}

/// Publishes the sheet of the surface shown, if a window shows sheets and the sheet is outdated.
void EditBaker::publish_sheet() {
    const SolidSpace space = pipeline_->recipe().solid.space;
    if (!front_.lacks_sheet(space)) return;
    front_.publish(std::make_shared<const AtlasSheet>(atlas_sheet(*pipeline_)), space);
    wake_();
}

/// Queues a new surface's jobs: building its BVH, and laying out a better atlas.
void EditBaker::queue_jobs(const Recipe& recipe, bool moving) {
    const std::shared_ptr<const EditSurface> shown = front_.surface();
    if (!shown) return;
    if (jobs_of_ != shown->number) {
        jobs_of_ = shown->number;
        const std::shared_ptr<const SurfacePick> found = front_.pick();
        // The BVH was built with the background atlas.
        if (found && &found->scene() == &shown->scene) return;
        jobs_.cancel();
        own_atlas_.forget();
        jobs_.add([this, shown](const std::stop_token&) {
            if (front_.publish(shown, pick_of(shown))) wake_();
        });
    }
    if (shown_atlas_ != recipe.atlas && !moving)
        own_atlas_.begin(pipeline_->mesh(), mesh_, pose_, recipe);
}

/// Publishes the recipe's pictures as OpenGL makes them; false where the host is to make them.
bool EditBaker::make_resident(const WorkerRequest& request) {
    const auto start = std::chrono::steady_clock::now();
    auto material = std::make_shared<EditMaterial>();
    material->numbers = scene_material(pipeline_->recipe());
    auto [plans, numbers] = material_plans(pipeline_->recipe());
    numbers.insert(numbers.begin(), material->numbers.texture);
    auto made =
        synthesizer_.make(*pipeline_, request.synthesis, plans, numbers, material->numbers.normals);
    bumps_made_ = made && made->numbers.back() == material->numbers.normals;
    if (!made) return false;
    EditPicture picture;
    picture.request = request.number;
    picture.side = std::uint32_t(made->pictures->side);
    picture.resident = std::move(*made);
    picture.by = synthesizer_.words();
    picture.material = std::move(material);
    picture.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!bumps_made_) picture.normals = normals_;
    finest_.reset();  // the host has no picture of it
    if (!request.moving && front_.wants_sheet())
        picture.texels = synthesizer_.read(picture.resident);
    publish(std::move(picture));
    return true;
}

/// Bakes and publishes one level of the pipeline's recipe after another, or level 0 alone where the
/// surface is a `better` layout of the one shown; false where `stop` was requested first.
bool EditBaker::bake_levels(const WorkerRequest& request, bool better,
                            const std::stop_token& stop) {
    const Recipe& recipe = pipeline_->recipe();
    auto start = std::chrono::steady_clock::now();
    const SliderState slider = request.moving ? SliderState::moving : SliderState::released;
    // With only paint changed, level 0 is quicker than a coarser level, its time says nothing about
    // level choice, and the sharp texture on screen need not become blurred first.
    LevelChoice finest(budget_, 0);
    const bool whole = better || (finest_ && only_paint_differs(*finest_, recipe));
    const auto make = [&](std::uint32_t level) { return make_level(level, stop); };
    const auto show = [&](std::uint32_t level, const MadeLevel& made) {
        const auto now = std::chrono::steady_clock::now();
        if (level == 0) finest_ = recipe;
        EditPicture picture;
        picture.request = request.number;
        picture.level = level;
        picture.side = std::uint32_t(made.texels->width());
        picture.by = synthesizer_.words();
        picture.texels = *made.texels;
        picture.levels = make_levels_(*made.texels);
        picture.material = made.material;
        picture.seconds = std::chrono::duration<double>(now - start).count();
        picture.normals = normals_;
        publish(std::move(picture));
        start = std::chrono::steady_clock::now();
    };
    return refine_made(whole ? finest : *choice_, slider, patience, make, show);
}

/// Makes a level of all pictures but the normals; nothing where `stop` was requested first.
std::optional<EditBaker::MadeLevel> EditBaker::make_level(std::uint32_t level,
                                                          const std::stop_token& stop) {
    const Recipe& recipe = pipeline_->recipe();
    const Image<Rgb8>* texels = pipeline_->picture<Rgb8>(level, stop);
    if (!texels) return {};
    const bool painted = level == 0 && finest_ && only_paint_differs(*finest_, recipe);
    if (!painted || !material_) material_ = edit_material(*pipeline_, level, make_levels_, stop);
    if (!material_) return {};
    return MadeLevel{texels, material_};
}

void EditBaker::work(const WorkerRequest& request, const std::stop_token& stop) {
    posed_ |= take_mesh();
    if (!pipeline_) return;
    check_lattice(request.recipe, pipeline_->mesh());
    Recipe recipe = request.recipe;
    recipe.atlas = take_atlas(request.recipe.atlas);
    const bool better = front_.coming_has_pick();  // laid out in the background
    const Recipe& before = pipeline_->recipe();
    if (before.atlas != recipe.atlas || before.solid.space != recipe.solid.space)
        synthesizer_.forget_atlas();
    pipeline_->set_recipe(recipe);
    if (better) normals_.reset();
    renew_surface(recipe, posed_ && !better);
    posed_ = false;
    const bool done = make_resident(request) || bake_levels(request, better, stop);
    if (done && !request.moving && shown_bumps_ && !bumps_made_) publish_normals();
    queue_jobs(request.recipe, request.moving);
    publish_sheet();
}

}  // namespace burl
