#include "app/editor/jobs/front_buffer.h"

namespace burl {

std::shared_ptr<const AtlasSheet> FrontBuffer::sheet() const {
    const std::scoped_lock lock(mutex_);
    return surface_ && sheet_of_.first == surface_->number ? sheet_ : nullptr;
}

void FrontBuffer::announce(std::shared_ptr<EditSurface> surface,
                           std::shared_ptr<const SurfacePick> pick) {
    const std::scoped_lock lock(mutex_);
    surface->number = ++numbers_;
    coming_ = std::move(surface);
    coming_pick_ = std::move(pick);
}

void FrontBuffer::publish(EditPicture picture, const StageRecords& records) {
    auto published = std::make_shared<EditPicture>(std::move(picture));
    const std::scoped_lock lock(mutex_);
    if (coming_) {
        surface_ = std::exchange(coming_, nullptr);
        if (coming_pick_) pick_ = std::exchange(coming_pick_, nullptr);
    }
    published->number = ++numbers_;
    published->surface = surface_->number;
    picture_ = std::move(published);
    records_ = records;
}

void FrontBuffer::publish(std::shared_ptr<const Image<Rgb8>> normals, const StageRecords& records) {
    const std::scoped_lock lock(mutex_);
    auto published = std::make_shared<EditPicture>(*picture_);
    published->number = ++numbers_;
    published->normals = std::move(normals);
    picture_ = std::move(published);
    records_ = records;
}

bool FrontBuffer::publish(const std::shared_ptr<const EditSurface>& of,
                          std::shared_ptr<const SurfacePick> pick) {
    const std::scoped_lock lock(mutex_);
    if (surface_ != of) return false;
    pick_ = std::move(pick);
    return true;
}

bool FrontBuffer::want_sheet(bool wanted) {
    const std::scoped_lock lock(mutex_);
    const bool begins = wanted && !wants_sheet_;
    wants_sheet_ = wanted;
    if (!wanted) sheet_.reset();
    return begins;
}

bool FrontBuffer::lacks_sheet(SolidSpace space) const {
    const std::scoped_lock lock(mutex_);
    if (!surface_ || coming_ || !wants_sheet_) return false;
    return !sheet_ || sheet_of_ != std::pair(surface_->number, space);
}

void FrontBuffer::publish(std::shared_ptr<const AtlasSheet> sheet, SolidSpace space) {
    const std::scoped_lock lock(mutex_);
    sheet_ = std::move(sheet);
    sheet_of_ = {surface_->number, space};
}

}  // namespace burl
