#pragma once
// How long the graphics processor takes. OpenGL works behind the caller's back, so draws are timed
// by a query in its own command stream and, as software OpenGL has no other clock than the host's,
// by the host's clock until all is done.
#include <chrono>

#include "app/gl_objects.h"

namespace burl {

/// Seconds.
struct GlSeconds {
    double gpu =
        0.0;  ///< between the first and the last command, by OpenGL's clock; 0: it has none
    double wall = 0.0;  ///< from start to the end of all commands, by the host's clock
};

/// One interval at a time; intervals of several timers of one context do not overlap.
class GlTimer {
  public:
    explicit GlTimer(const GladGLContext& gl);
    /// Waits for the commands before it.
    void start();
    /// Waits for the commands since start().
    GlSeconds stop();

  private:
    const GladGLContext& gl_;
    GlName<&GladGLContext::DeleteQueries> query_;
    bool has_clock_ = false;
    std::chrono::steady_clock::time_point begin_{};
};

}  // namespace burl
