#include "app/gl_timer.h"

namespace burl {

namespace {

GLuint make_query(const GladGLContext& gl) {
    GLuint query = 0;
    gl.GenQueries(1, &query);
    return query;
}

/// Zero bits: the query is there but has no clock behind it.
bool has_clock(const GladGLContext& gl) {
    GLint bits = 0;
    gl.GetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    return bits > 0;
}

}  // namespace

GlTimer::GlTimer(const GladGLContext& gl)
    : gl_(gl), query_(gl, make_query(gl)), has_clock_(has_clock(gl)) {}

void GlTimer::start() {
    gl_.Finish();
    begin_ = std::chrono::steady_clock::now();
    if (has_clock_) gl_.BeginQuery(GL_TIME_ELAPSED, query_.get());
}

GlSeconds GlTimer::stop() {
    if (has_clock_) gl_.EndQuery(GL_TIME_ELAPSED);
    gl_.Finish();
    GlSeconds seconds;
    seconds.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    GLuint64 nanoseconds = 0;
    if (has_clock_) gl_.GetQueryObjectui64v(query_.get(), GL_QUERY_RESULT, &nanoseconds);
    seconds.gpu = double(nanoseconds) * 1e-9;
    check_gl(gl_, "timing");
    return seconds;
}

}  // namespace burl
