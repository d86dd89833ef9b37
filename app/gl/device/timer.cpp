#include "app/gl/device/timer.h"

namespace burl {

namespace {

/// Whether time stamps have a clock; a query without one has zero bits.
bool has_clock(const GladGLContext& gl) {
    GLint bits = 0;
    gl.GetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
    return bits > 0;
}

GLuint64 nanoseconds(const GladGLContext& gl, GLuint query) {
    GLuint64 result = 0;
    gl.GetQueryObjectui64v(query, GL_QUERY_RESULT, &result);
    return result;
}

}  // namespace

GlTimer::GlTimer(const GladGLContext& gl)
    : gl_(gl), first_(gl), last_(gl), has_clock_(has_clock(gl)) {}

void GlTimer::start() {
    gl_.Finish();
    begin_ = std::chrono::steady_clock::now();
    if (!has_clock_) return;
    gl_.QueryCounter(first_.get(), GL_TIMESTAMP);
    // Llvmpipe would otherwise take the time stamp again for every bin of the draws that follow.
    gl_.Flush();
}

GlSeconds GlTimer::stop() {
    if (has_clock_) gl_.QueryCounter(last_.get(), GL_TIMESTAMP);
    gl_.Finish();
    GlSeconds seconds;
    seconds.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    if (has_clock_)
        seconds.gpu =
            double(GLint64(nanoseconds(gl_, last_.get()) - nanoseconds(gl_, first_.get()))) * 1e-9;
    check_gl(gl_, "timing");
    return seconds;
}

}  // namespace burl
