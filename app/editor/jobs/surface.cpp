#include "app/editor/jobs/surface.h"

#include <utility>

#include <tbb/parallel_invoke.h>

#include "app/gl/draw/view_scene.h"
#include "app/scene/scene.h"

namespace burl {

std::shared_ptr<EditSurface> edit_surface(const SceneParts& parts, const MeshPose* pose) {
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

std::shared_ptr<const SurfacePick> pick_of(const std::shared_ptr<const EditSurface>& surface,
                                           double share) {
    return std::make_shared<const SurfacePick>(
        std::shared_ptr<const Scene>(surface, &surface->scene), share);
}

EditPosedPick::EditPosedPick(std::function<void()> wake)
    : worker_([this](const WorkerRequest&, const std::stop_token&) { work(); }, std::move(wake)) {}

void EditPosedPick::follow(const std::shared_ptr<const EditSurface>& surface, double share,
                           bool moving) {
    Wish wish{surface, share};
    if (share == 0.0 || !surface || !surface->posed) wish = {};
    if (wish == asked_ || (moving && wish.surface)) return;
    asked_ = wish;
    {
        const std::scoped_lock lock(mutex_);
        wish_ = std::move(wish);
        if (!wish_.surface) pick_.reset();
    }
    if (asked_.surface) worker_.request({});
}

std::shared_ptr<const SurfacePick> EditPosedPick::pick(
    const std::shared_ptr<const EditSurface>& surface, double share) const {
    const std::scoped_lock lock(mutex_);
    const bool fits = pick_ && &pick_->scene() == &surface->scene && pick_->share() == share;
    return fits ? pick_ : nullptr;
}

void EditPosedPick::work() {
    Wish wish;
    {
        const std::scoped_lock lock(mutex_);
        wish = wish_;
    }
    if (!wish.surface) return;
    auto pick = pick_of(wish.surface, wish.share);
    const std::scoped_lock lock(mutex_);
    if (wish_ == wish) pick_ = std::move(pick);
}

}  // namespace burl
