#include "app/editor/jobs/view_maker.h"

#include <utility>

namespace burl {

namespace {

/// Makes the picture of a texture's error; empty: `stop` was requested first.
std::optional<SheetPicture> error_picture(const ViewWish& wish, const std::stop_token& stop) {
    SheetPicture picture{wish};
    picture.problem = no_reference(*wish.recipe, wish.sheet->box);
    if (!picture.problem.empty()) return picture;
    auto error = texture_error(wish.sheet->solid, *wish.recipe, wish.picture->texels, stop);
    if (!error) return {};
    picture.levels = error_levels(*error);
    picture.largest = error->largest;
    picture.rms = error->rms;
    picture.codes = std::move(error->codes);
    return picture;
}

bool has_picture(const ViewWish& wish) {
    return wish.sheet && wish.mode != SheetMode::texture &&
           (wish.mode != SheetMode::error || (wish.picture && wish.recipe));
}

}  // namespace

EditViewMaker::EditViewMaker(std::function<void()> wake)
    : worker_([this](const WorkerRequest&, const std::stop_token& stop) { work(stop); },
              std::move(wake)) {}

void EditViewMaker::request(ViewWish wish) {
    if (wish == wish_) return;
    wish_ = wish;
    {
        const std::scoped_lock lock(mutex_);
        if (!wish.lines) surface_.reset(), lines_.reset();
        if (!wish.sheet) picture_.reset();
        next_ = std::move(wish);
    }
    worker_.request({});
}

std::shared_ptr<const SheetPicture> EditViewMaker::picture() const {
    const std::scoped_lock lock(mutex_);
    return picture_;
}

std::shared_ptr<const SurfaceLines> EditViewMaker::lines() const {
    const std::scoped_lock lock(mutex_);
    return surface_ == wish_.lines ? lines_ : nullptr;
}

void EditViewMaker::make_lines(const std::shared_ptr<const EditSurface>& surface) {
    auto lines = std::make_shared<const SurfaceLines>(surface_lines(surface->scene));
    const std::scoped_lock lock(mutex_);
    if (next_.lines != surface) return;  // the surface is no longer wished for
    lines_ = std::move(lines);
    surface_ = surface;
}

void EditViewMaker::make_picture(const ViewWish& wish, const std::stop_token& stop) {
    std::optional<SheetPicture> picture;
    if (wish.mode == SheetMode::error)
        picture = error_picture(wish, stop);
    else
        picture = SheetPicture{wish, sheet_levels(*wish.sheet, wish.mode)};
    if (!picture) return;
    const std::scoped_lock lock(mutex_);
    if (!next_.sheet) return;  // atlas pictures are no longer wished for
    picture_ = std::make_shared<const SheetPicture>(std::move(*picture));
}

/// Makes the parts of the wish that are not there yet.
void EditViewMaker::work(const std::stop_token& stop) {
    ViewWish wish;
    bool lines = false, picture = false;
    {
        const std::scoped_lock lock(mutex_);
        wish = next_;
        lines = wish.lines && wish.lines != surface_;
        const ViewWish* made = picture_ ? &picture_->of : nullptr;
        picture =
            has_picture(wish) && !(made && made->sheet == wish.sheet && made->mode == wish.mode &&
                                   made->picture == wish.picture && made->recipe == wish.recipe);
    }
    if (picture) make_picture(wish, stop);
    if (lines && !stop.stop_requested()) make_lines(wish.lines);
}

}  // namespace burl
