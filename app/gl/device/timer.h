#pragma once
// Timing of OpenGL commands. OpenGL runs asynchronously, so draws are timed by two time stamps in
// its own command stream (GL_TIMESTAMP; Mesa's llvmpipe gives wrong results for GL_TIME_ELAPSED of
// draws that not all of its threads took part in), and by the host's clock until all commands are
// done.
#include <chrono>

#include "app/gl/device/objects.h"

namespace burl {

/// Durations in seconds.
struct GlSeconds {
    /// The time from the first to the last command, by OpenGL's clock; 0 where it has none.
    double gpu = 0.0;
    double wall = 0.0;  ///< the time until all commands are done, by the host's clock
};

/// A stopwatch for one interval at a time.
class GlTimer {
  public:
    explicit GlTimer(const GladGLContext& gl);
    /// Waits for all earlier commands and starts the interval.
    void start();
    /// Waits for the commands since start() and returns the interval. Throws Error(runtime) when
    /// OpenGL fails.
    GlSeconds stop();

  private:
    const GladGLContext& gl_;
    GlQuery first_, last_;
    bool has_clock_ = false;
    std::chrono::steady_clock::time_point begin_{};
};

}  // namespace burl
