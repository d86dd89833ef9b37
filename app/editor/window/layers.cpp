#include "app/editor/window/layers.h"

#include "app/gl/draw/layers.h"

namespace burl {

namespace {

constexpr int most_layers = 12;  ///< each is drawn as long as the whole object is

/// Counts the samples that are drawn while it lives.
class SampleCount {
  public:
    explicit SampleCount(const GladGLContext& gl) : gl_(gl) {
        gl_.GenQueries(1, &query_);
        gl_.BeginQuery(GL_SAMPLES_PASSED, query_);
    }
    SampleCount(const SampleCount&) = delete;
    SampleCount& operator=(const SampleCount&) = delete;
    ~SampleCount() { gl_.DeleteQueries(1, &query_); }

    /// Ends counting, and waits for the result.
    GLuint end() const {
        gl_.EndQuery(GL_SAMPLES_PASSED);
        GLuint count = 0;
        gl_.GetQueryObjectuiv(query_, GL_QUERY_RESULT, &count);
        return count;
    }

  private:
    const GladGLContext& gl_;
    GLuint query_ = 0;
};

}  // namespace

GlEditLayers::GlEditLayers(const GladGLContext& gl)
    : gl_(&gl), copy_(gl, "maps/full_screen.vert", "draw/layer.frag"), pass_(gl) {}

void GlEditLayers::draw(const GlScene& scene, const Camera& camera, const GlShading& shading,
                        const GlDepthTarget& target) {
    const GlSize size = target.colors.size();
    if (!layer_ || layer_->colors.size() != size) {
        layer_.emplace(*gl_, PictureSize{size.x, size.y}, GL_RGBA16F, GL_DEPTH_COMPONENT32F);
        sum_.emplace(*gl_, size, std::initializer_list<GLenum>{GL_RGBA16F});
    }
    target.colors.bind();
    GlLayerDepths depths(*gl_, size.x, size.y);
    sum_->clear(0, Vec4f(0.0f));
    for (int i = 0; i < most_layers && draw_layer(scene, camera, shading, depths); ++i) {
        depths.take_layer();
        add(layer_->colors.texture(), *sum_, GL_ONE, GL_ONE_MINUS_DST_ALPHA);
    }
    add(sum_->texture(), target.colors, GL_ONE_MINUS_SRC_ALPHA, GL_ONE);
    check_gl(*gl_, "drawing layers");
}

/// Draws what lies behind the depths; returns whether there was anything.
bool GlEditLayers::draw_layer(const GlScene& scene, const Camera& camera, const GlShading& shading,
                              const GlLayerDepths& depths) {
    const GlSize size = layer_->colors.size();
    layer_->colors.bind();
    const SampleCount count(*gl_);
    scene.draw_layer(camera, {size.x, size.y}, {0, 0, size.x, size.y}, shading, depths);
    return count.end() > 0;
}

/// Adds colours to a target's, each of both by its share.
void GlEditLayers::add(const GlTexture& colors, const GlTarget& sum, GLenum sum_share,
                       GLenum color_share) {
    sum.bind();
    copy_.use();
    bind_texture(*gl_, copy_, "layer", 0, colors);
    gl_->Disable(GL_DEPTH_TEST);
    gl_->Enable(GL_BLEND);
    gl_->BlendFunc(color_share, sum_share);
    pass_.draw();
    gl_->Disable(GL_BLEND);
}

}  // namespace burl
