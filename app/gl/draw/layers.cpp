#include "app/gl/draw/layers.h"

#include <vector>

namespace burl {

namespace {

/// Fills a texture of depths with 0, the nearest.
void make_depths(const GladGLContext& gl, const GlTexture& depths, int width, int height) {
    const std::vector<float> nearest(std::size_t(width) * std::size_t(height), 0.0f);
    gl.BindTexture(GL_TEXTURE_2D, depths.get());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, width, height, 0, GL_DEPTH_COMPONENT,
                  GL_FLOAT, nearest.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace

GlLayerDepths::GlLayerDepths(const GladGLContext& gl, int width, int height)
    : gl_(gl), width_(width), height_(height), nearer_(gl), farther_(gl) {
    gl_.ActiveTexture(GL_TEXTURE0);
    make_depths(gl_, nearer_, width, height);
    make_depths(gl_, farther_, width, height);
    take(farther_);
}

void GlLayerDepths::take(const GlTexture& depths) const {
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, depths.get());
    gl_.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, width_, height_);
    check_gl(gl_, "keeping the depths of a layer");
}

void GlLayerDepths::take_layer() {
    take(nearer_);
}

void GlLayerDepths::bind() const {
    gl_.ActiveTexture(GL_TEXTURE0 + nearer_unit);
    gl_.BindTexture(GL_TEXTURE_2D, nearer_.get());
    gl_.ActiveTexture(GL_TEXTURE0 + farther_unit);
    gl_.BindTexture(GL_TEXTURE_2D, farther_.get());
}

}  // namespace burl
