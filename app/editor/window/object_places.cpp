// The G-buffer of the object's view, and what is made ready while the view rests.
#include <utility>

#include "app/editor/window/object.h"

namespace burl {

/// Whether a G-buffer can hold the view's lookups and light. In an environment's light a large
/// surface would be drawn for seconds.
bool GlEditObject::holds_places(const ObjectViewOptions& options) const {
    if (!scene_ || !is_direct(options) || options.half) return false;
    return options.light ? !scene_->has_coarse() && scene_->has_places(true) : scene_->has_places();
}

bool GlEditObject::keeps_places(const ObjectViewOptions& options) const {
    return holds_places(options) && (!options.light || placed_ == options);
}

/// Shades from the G-buffer where it is ready, or only the texture has changed since the last
/// frame; returns whether that was possible.
bool GlEditObject::draw_places(const ObjectViewOptions& options) {
    if (!keeps_places(options) || (seen_ != options && placed_ != options)) return false;
    if (placed_ != options) find_places(options, {});
    places_.draw(*texture(), *shown_, shading_of(options));
    return true;
}

/// Draws a part of the G-buffer.
void GlEditObject::find_places(const ObjectViewOptions& options, const ViewPart& part) {
    const GlShading shading = shading_of(options);
    scene_->set_target_share(options.share);
    if (part.number == 0) places_.begin(*shown_, shading);
    placed_.reset();
    keep_to(part, options.size);
    places_.find(*scene_, camera_of(options.camera, surface_->sphere, options.size), shading,
                 part.triangles());
    gl_->Disable(GL_SCISSOR_TEST);
    if (part.is_last()) placed_ = options;
}

void GlEditObject::prepare(const ObjectViewOptions& moving) {
    const bool rests = is_software_ && scene_ && pictured_ && drawn_ && part_ == 0;
    if (!rests || moving.size != drawn_->size || !shown_ || !picture_) return;
    if (std::exchange(tried_, moving) != moving) return try_programs(moving);
    if (!holds_places(moving) || placed_ == moving) return;
    if (std::exchange(placing_, moving) != moving) place_part_ = 0;
    const ViewPart part = part_of(moving, place_part_);
    find_places(moving, part);
    place_part_ = part.is_last() ? 0 : part.number + 1;
}

bool GlEditObject::preparing() const {
    return place_part_ > 0;
}

/// Draws the moving view very small: a software OpenGL compiles programs when it draws.
void GlEditObject::try_programs(const ObjectViewOptions& moving) {
    if (!trial_) trial_.emplace(*gl_, PictureSize{8, 8}, GL_RGBA8);
    const PictureSize size{8, 8};
    const Camera camera = camera_of(moving.camera, surface_->sphere, size);
    trial_->colors.bind();
    if (scene_->has_coarse())
        scene_->draw_coarse(camera, size, {0, 0, 8, 8}, shading_of(moving));
    else
        scene_->draw_encoded(camera, size, {0, 0, 8, 8}, shading_of(moving));
    gl_->Disable(GL_DEPTH_TEST);
}

}  // namespace burl
