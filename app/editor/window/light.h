#pragma once
// The light of the editor's view: the headlight, or a built-in environment that is prefiltered on a
// thread of its own when it is chosen.
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <string_view>

#include "app/gl/draw/light.h"

namespace burl {

/// All functions are called by the user interface's thread.
class EditLight {
  public:
    /// The name of the light without an environment.
    static constexpr std::string_view headlight = "headlight";

    /// The headlight. `wake` is called by another thread when an environment's light is ready.
    EditLight(const GladGLContext& gl, std::function<void()> wake);

    /// Chooses an environment (app/light/environment.h), or the headlight.
    void choose(std::string_view name);
    const std::string& name() const { return name_; }
    /// The light chosen, or, until it is ready, the one before; null: the headlight. The OpenGL
    /// context must be current.
    std::shared_ptr<const GlLight> light();
    /// The last result of light(), for the host; null: the headlight.
    const std::shared_ptr<const PrefilteredLight>& on_host() const { return on_host_; }

    /// Whether the first light of all is still being prepared, before which nothing is lit.
    bool begins() const { return coming_.valid() && !light_ && !lit_; }
    /// Whether the light chosen is the one that light() last returned.
    bool idle() const { return !coming_.valid(); }
    void wait() const {
        if (coming_.valid()) coming_.wait();
    }

  private:
    const GladGLContext* gl_;
    std::function<void()> wake_;
    std::string name_{headlight};
    std::shared_ptr<const GlLight> light_;
    std::shared_ptr<const PrefilteredLight> on_host_;
    std::future<PrefilteredLight> coming_;
    bool lit_ = false;  ///< whether light() has returned the light chosen
};

}  // namespace burl
