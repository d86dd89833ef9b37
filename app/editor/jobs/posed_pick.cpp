#include "app/editor/jobs/posed_pick.h"

#include <utility>

namespace burl {

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
    // The scene lives as long as its surface.
    auto pick = std::make_shared<const SurfacePick>(
        std::shared_ptr<const Scene>(wish.surface, &wish.surface->scene), wish.share);
    const std::scoped_lock lock(mutex_);
    if (wish_ == wish) pick_ = std::move(pick);
}

}  // namespace burl
