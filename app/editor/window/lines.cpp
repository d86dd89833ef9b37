#include "app/editor/window/lines.h"

namespace burl {

namespace {

/// Share of its distance by which a line is moved towards the eye, in front of its surface.
constexpr double nearer = 2e-3;

struct Look {
    Vec4f color;  ///< linear light
    float width;  ///< line width in pixels
};
constexpr Look edges_look{{0.0f, 0.0f, 0.0f, 0.5f}, 1.0f};
constexpr Look borders_look{{1.0f, 0.32f, 0.02f, 1.0f}, 2.0f};

}  // namespace

GlEditLines::GlEditLines(const GladGLContext& gl)
    : gl_(&gl), program_(gl, "draw/lines.vert", "draw/lines.frag") {}

void GlEditLines::show(std::shared_ptr<const SurfaceLines> lines, const Sphere& sphere) {
    lines_ = std::move(lines);
    sphere_ = sphere;
    if (!(sphere_.radius > 0.0)) sphere_.radius = 1.0;
    edges_.reset();
    borders_.reset();
}

/// Uploads line ends as two vertex attributes, numbered from `first`.
void GlEditLines::upload(const Uploaded& into, const GlBuffer& buffer, const Ends& ends,
                         GLuint first) const {
    gl_->BindVertexArray(into.vertex_array.get());
    gl_->BindBuffer(GL_ARRAY_BUFFER, buffer.get());
    gl_->BufferData(GL_ARRAY_BUFFER, GLsizeiptr(ends.size() * sizeof(ends[0])), ends.data(),
                    GL_STATIC_DRAW);
    for (GLuint end = 0; end < 2; ++end) {
        gl_->EnableVertexAttribArray(first + end);
        gl_->VertexAttribPointer(first + end, 3, GL_FLOAT, GL_FALSE, sizeof(ends[0]),
                                 reinterpret_cast<const void*>(end * sizeof(Vec3f)));
        gl_->VertexAttribDivisor(first + end, 1);
    }
}

/// Uploads lines in units of the enclosing sphere, so that float32 suffices wherever it lies.
GlEditLines::Uploaded GlEditLines::upload(Kind kind) const {
    Ends ends, changes;
    const auto add = [&](const SurfaceLine& line) {
        ends.push_back({Vec3f((line.from - sphere_.centre) / sphere_.radius),
                        Vec3f((line.to - sphere_.centre) / sphere_.radius)});
    };
    const auto add_change = [&](const SurfaceLine& line) {
        changes.push_back({Vec3f(line.from / sphere_.radius), Vec3f(line.to / sphere_.radius)});
    };
    const bool moves = !lines_->changes.empty();
    if (kind == Kind::edges) {
        for (const SurfaceLine& line : lines_->edges) add(line);
        for (const SurfaceLine& line : lines_->changes) add_change(line);
    } else {
        for (const BorderLine& border : lines_->borders) add(border.line);
        for (const BorderLine& border : lines_->borders)
            if (moves) add_change(border.change);
    }
    Uploaded uploaded{GlVertexArray(*gl_), GlBuffer(*gl_), GlBuffer(*gl_), GLsizei(ends.size())};
    upload(uploaded, uploaded.ends, ends, 0);
    if (moves) upload(uploaded, uploaded.changes, changes, 2);
    check_gl(*gl_, "uploading lines");
    return uploaded;
}

void GlEditLines::draw(Kind kind, const Camera& camera, const PictureSize& samples, int pixel,
                       double share) {
    if (!lines_) return;
    std::optional<Uploaded>& lines = kind == Kind::edges ? edges_ : borders_;
    if (!lines) lines = upload(kind);
    if (lines->count == 0) return;
    const Look& look = kind == Kind::edges ? edges_look : borders_look;
    const TileView view(camera, samples, {0, 0, samples.width, samples.height});
    Mat4d scene_from_unit(sphere_.radius);
    scene_from_unit[3] = Vec4d(sphere_.centre, 1.0);
    Mat4d to_the_eye(1.0 - nearer);
    to_the_eye[3][3] = 1.0;
    program_.use();
    program_.set("clip_from_unit", glm::mat4(view.clip_from_eye * to_the_eye * view.eye_from_scene *
                                             scene_from_unit));
    program_.set("size", glm::vec2(float(samples.width), float(samples.height)));
    program_.set("width", look.width * float(pixel));
    program_.set("color", look.color);
    program_.set("share", float(lines_->changes.empty() ? 0.0 : share));
    gl_->Enable(GL_DEPTH_TEST);
    gl_->Enable(GL_BLEND);
    gl_->BlendEquation(GL_FUNC_ADD);
    gl_->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl_->BindVertexArray(lines->vertex_array.get());
    gl_->DepthMask(GL_FALSE);  // lines do not hide one another
    gl_->DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, lines->count);
    gl_->DepthMask(GL_TRUE);
    gl_->Disable(GL_BLEND);
    check_gl(*gl_, "drawing lines");
}

}  // namespace burl
