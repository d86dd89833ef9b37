#include "app/editor/window/light.h"

#include <chrono>
#include <utility>

namespace burl {

EditLight::EditLight(const GladGLContext& gl, std::function<void()> wake)
    : gl_(&gl), wake_(std::move(wake)) {}

void EditLight::choose(std::string_view name) {
    if (name == name_) return;
    name_ = name;
    coming_ = {};  // waits for an environment that is no longer wanted
    if (name_ == headlight) {
        light_.reset();
        on_host_.reset();
        return;
    }
    coming_ = std::async(std::launch::async, [environment = name_, wake = wake_] {
        PrefilteredLight light = prefilter(make_environment(environment));
        wake();
        return light;
    });
}

std::shared_ptr<const GlLight> EditLight::light() {
    const bool ready =
        coming_.valid() && coming_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (ready) {
        on_host_ = std::make_shared<const PrefilteredLight>(coming_.get());
        light_ = std::make_shared<const GlLight>(*gl_, *on_host_);
    }
    lit_ = lit_ || !coming_.valid();
    return light_;
}

}  // namespace burl
