#pragma once
// How long the graphics processor takes. OpenGL works behind the caller's back, so draws are timed
// by two time stamps in its own command stream (GL_TIMESTAMP; Mesa's llvmpipe gives nonsense for
// GL_TIME_ELAPSED of draws that not all of its threads took part in), and by the host's clock until
// all is done.
#include <chrono>

#include "app/gl/device/objects.h"

namespace burl {

/// Seconds.
struct GlSeconds {
    double gpu =
        0.0;  ///< between the first and the last command, by OpenGL's clock; 0: it has none
    double wall = 0.0;  ///< from start to the end of all commands, by the host's clock
};

/// One interval at a time.
class GlTimer {
  public:
    explicit GlTimer(const GladGLContext& gl);
    /// Waits for the commands before it.
    void start();
    /// Waits for the commands since start().
    GlSeconds stop();

  private:
    const GladGLContext& gl_;
    GlName<&GladGLContext::DeleteQueries> first_, last_;
    bool has_clock_ = false;
    std::chrono::steady_clock::time_point begin_{};
};

}  // namespace burl
