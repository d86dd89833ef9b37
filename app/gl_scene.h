#pragma once
// A scene on the GPU, drawn tile by tile: its colours, or what of a texture they were looked up
// from (the feedback pass of virtual texturing: Barrett, "Sparse Virtual Textures", 2008).
#include <map>
#include <optional>
#include <vector>

#include "app/gl_objects.h"
#include "app/gl_surface.h"
#include "app/scene.h"

namespace burl {

/// The context must be current wherever one is made, used or destroyed.
class GlScene {
  public:
    /// `filter` replaces the one each texture asks for. Throws Error: unsupported when a texture
    /// is larger than the context allows, runtime when OpenGL fails.
    GlScene(const GladGLContext& gl, const Scene& scene,
            std::optional<TextureFilter> filter = std::nullopt);

    /// Replaces the pixels of texture `number` of the scene; how it is looked up stays.
    void set_texture(int number, const SceneTexture& texture);

    const GlTexture& texture(int number) const { return textures_[std::size_t(number)]; }

    /// Draws one tile of the picture in linear light into the bound framebuffer; `lit`: under the
    /// headlight of app/shading.h.
    void draw(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
              bool lit) const;

    /// The same in sRGB codes, where a sample is a pixel of the screen.
    void draw_encoded(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                      bool lit) const;

    /// Draws instead what every sample looks up of texture `number` (LookupSample,
    /// app/view_texels.h), whose sides have `size` texels whatever was uploaded.
    void draw_lookups(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                      int number, std::uint32_t size) const;

  private:
    void clear(const SampleTile& tile, const Vec3f& color) const;
    void bind(GLenum unit, int number) const;
    /// What the program that draws a surface is made for.
    struct Look {
        bool encoded = false, lit = false, bumped = false, levels = false, in_blocks = false;
        auto operator<=>(const Look&) const = default;
    };
    const GlProgram& use(const Look& look) const;
    void draw_surfaces(const TileView& view, bool lit, bool encoded) const;

    const GladGLContext& gl_;
    GlProgram lookups_;
    mutable std::map<Look, GlProgram> programs_;  ///< those that were wanted so far
    GlTexture white_;
    std::vector<GlTexture> textures_;
    std::vector<TextureFilter> filters_;  ///< per texture
    std::vector<GlSurface> surfaces_;
};

}  // namespace burl
