#pragma once
// A scene on the GPU, drawn tile by tile: its colours, or what of a texture they were looked up
// from (the feedback pass of virtual texturing: Barrett, "Sparse Virtual Textures", 2008).
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/gl/device/objects.h"
#include "app/gl/draw/scene_programs.h"
#include "app/gl/draw/surface.h"
#include "app/scene/scene.h"

namespace burl {

/// The context must be current wherever one is made, used or destroyed.
class GlScene {
  public:
    /// `filter` replaces the one each texture asks for. Throws Error: unsupported when a texture
    /// is larger than the context allows, runtime when OpenGL fails.
    GlScene(const GladGLContext& gl, const Scene& scene,
            std::optional<TextureFilter> filter = std::nullopt);
    /// The same with programs that others use, too, and without what its surfaces show: that comes
    /// with upload(). `frames` are the surfaces' (app/scene/unit_frame.h).
    GlScene(const GladGLContext& gl, const Scene& scene, std::shared_ptr<GlScenePrograms> programs,
            std::span<const Mat4d> frames);

    /// The next piece of the surfaces of the scene it was made for, of about `bytes`. Whether all
    /// are there: not to be drawn before.
    bool upload(const Scene& scene, std::size_t bytes);

    /// Replaces the pixels of texture `number` of the scene; how it is looked up stays.
    void set_texture(int number, const SceneTexture& texture);

    /// How far all surfaces that have a target have gone there; 0 to 1.
    void set_target_share(double share);

    const GlTexture& texture(int number) const { return textures_[std::size_t(number)]; }

    /// Draws one tile of the picture in linear light into the bound framebuffer; `lit`: under the
    /// headlight of app/scene/shading.h.
    void draw(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
              bool lit) const;

    /// The same in sRGB codes, where a sample is a pixel of the screen.
    void draw_encoded(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                      bool lit) const;

    /// The background in such codes.
    static Vec4f background_codes();
    /// Whether draw_places() can: all that surfaces show is one texture with levels, looked up
    /// without blocks.
    bool has_places() const;
    /// Draws instead where every sample looks that texture up: u, v, level and share of its light.
    void draw_places(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                     bool lit) const;

    /// Draws instead what every sample looks up of texture `number` (LookupSample,
    /// app/gl/draw/view_texels.h), whose sides have `size` texels whatever was uploaded.
    void draw_lookups(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                      int number, std::uint32_t size) const;

  private:
    void clear(const SampleTile& tile, const Vec4f& color) const;
    bool has_levels(const GlSurface& surface) const;
    void bind(GLenum unit, int number) const;
    void make_textures(const Scene& scene, std::optional<TextureFilter> filter);
    void draw_surfaces(const TileView& view, const GlScenePrograms::Look& look) const;

    const GladGLContext& gl_;
    std::shared_ptr<GlScenePrograms> programs_;
    GlTexture white_;
    std::vector<GlTexture> textures_;
    std::vector<TextureFilter> filters_;  ///< per texture
    std::vector<GlSurface> surfaces_;
    std::size_t uploaded_ = 0;  ///< surfaces that are there
};

}  // namespace burl
