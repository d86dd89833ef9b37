#pragma once
// A scene uploaded to OpenGL and drawn in tiles: its colours, or the texture coordinates that it
// looks up (the feedback pass of virtual texturing: Barrett, "Sparse Virtual Textures", 2008).
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/gl/draw/layers.h"
#include "app/gl/draw/light.h"
#include "app/gl/draw/programs.h"
#include "app/gl/draw/surface.h"
#include "app/scene/scene.h"

namespace burl {

/// How the surfaces of a scene are shaded.
struct GlShading {
    bool lit = true;                 ///< false: by their colours alone
    const GlLight* light = nullptr;  ///< of an environment; null: the headlight
    float exposure = 1.0f;           ///< factor of light, in encoded pictures
    bool tone_curve = false;         ///< whether encoded pictures have it
};

/// Textures and surfaces of a scene. The context must be current wherever an object is created,
/// used or destroyed.
class GlScene {
  public:
    /// Uploads the whole scene; `filter` replaces the filter of all textures. Throws Error:
    /// unsupported where a texture is larger than the context allows, runtime when OpenGL fails.
    GlScene(const GladGLContext& gl, const Scene& scene,
            std::optional<TextureFilter> filter = std::nullopt);
    /// Uploads the textures, and leaves the surfaces to upload(). `programs` may be shared with
    /// other scenes; `frames` holds the surfaces' unit_frame (app/scene/scene.h).
    GlScene(const GladGLContext& gl, const Scene& scene, std::shared_ptr<GlScenePrograms> programs,
            std::span<const Mat4d> frames);

    /// Uploads the next piece, of about `bytes`, of the surfaces of the scene it was created for.
    /// Returns whether all are uploaded; the scene must not be drawn before.
    bool upload(const Scene& scene, std::size_t bytes);

    /// Replaces the pixels of texture `number`; its filter stays.
    void set_texture(int number, const SceneTexture& texture);
    /// Has texture `number` be one that somebody else owns, with a filter of its own; null: none.
    void lend_texture(int number, const GlTexture* lent);

    /// Replaces the material of all surfaces.
    void set_material(const SceneMaterial& material);
    /// Has lookups that choose a MIP level be made of up to `probes` of them along a footprint's
    /// longer side; at first of one.
    void set_anisotropy(int probes) { most_probes_ = probes; }
    /// Whether a surface looks up MIP levels.
    bool has_levels() const;
    /// Sets the weight, 0..1, of the morph targets of all surfaces that have one.
    void set_target_share(double share);

    const GlTexture& texture(int number) const {
        const GlTexture* const lent = lent_[std::size_t(number)];
        return lent ? *lent : textures_[std::size_t(number)];
    }

    /// Clears a tile of the bound framebuffer to a colour.
    void clear(const SampleTile& tile, const Vec4f& color) const;
    /// Draws a tile of the picture in linear light into the bound framebuffer, over what it shows;
    /// its depth must be cleared. Alpha is 1. Surfaces that blend are left to draw_layer(). All
    /// parts, one after the other, are the picture.
    void draw(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
              const GlShading& shading, const DrawPart& part = {}) const;

    /// Whether a surface blends with what lies behind it.
    bool has_layers() const;
    /// Draws the frontmost surfaces that blend, of those between the depths that `depths` binds:
    /// their colours multiplied by alpha, and alpha, which is 0 where there are none.
    void draw_layer(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                    const GlShading& shading, const GlLayerDepths& depths) const;

    /// Draws the surfaces that blend over what the bound framebuffer shows, their far sides before
    /// their near ones: what a picture that moves shows of layers.
    void draw_blended(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                      const GlShading& shading) const;

    /// Draws a tile of the picture in sRGB codes, for a framebuffer whose samples are pixels of the
    /// screen.
    void draw_encoded(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                      const GlShading& shading) const;

    /// Sets surfaces that stand for the scene's own while it moves (app/scene/coarse_surface.h),
    /// with the frames of those; none: they are dropped.
    void set_coarse(const std::vector<Surface>& surfaces, std::span<const Mat4d> frames);
    /// Whether there are such surfaces, and all is opaque.
    bool has_coarse() const;
    /// Draws a tile as draw_encoded() does, of the coarse surfaces, shaded at their vertices.
    void draw_coarse(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                     const GlShading& shading) const;

    /// The background colour in sRGB codes of 0..1.
    static Vec4f background_codes();
    /// Whether draw_places() applies: all surfaces show the same texture with MIP levels, without
    /// normal map, colour factor, vertex colours or blocks; in an environment's light
    /// also without other pictures and metal, so that light is linear in the base colour.
    bool has_places(bool in_environment = false) const;
    /// Draws a tile of lookups of the surfaces' one texture, over what it shows: u, v, level and
    /// light of every sample; in an environment's light that of a black surface, and what a white
    /// one sends besides, into two more targets.
    void draw_places(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                     const GlShading& shading, const DrawPart& part = {}) const;

    /// Draws a tile of lookups of texture `number` (LookupSample, app/gl/draw/view_texels.h), whose
    /// side is `size` texels whatever was uploaded.
    void draw_lookups(const Camera& camera, const PictureSize& samples, const SampleTile& tile,
                      int number, std::uint32_t size) const;

  private:
    bool has_levels(const GlSurface& surface) const;
    void bind(GLenum unit, int number) const;
    void make_textures(const Scene& scene, std::optional<TextureFilter> filter);
    enum class Drawn { all, solid, layers };
    bool draws(const GlSurface& surface, Drawn drawn) const;
    GlScenePrograms::Look look_of(const GlSurface& surface, GlScenePrograms::Look look) const;
    void bind_material(const GlProgram& program, const SceneMaterial& material) const;
    void draw_surfaces(const TileView& view, GlScenePrograms::Look look, const GlShading& shading,
                       Drawn drawn, const DrawPart& part = {}) const;
    void draw_surface(const GlSurface& surface, const TileView& view,
                      const GlScenePrograms::Look& look, const GlShading& shading,
                      const DrawPart& part = {}) const;

    const GladGLContext& gl_;
    std::shared_ptr<GlScenePrograms> programs_;
    GlTexture white_;
    std::vector<GlTexture> textures_;
    std::vector<const GlTexture*> lent_;  ///< in the place of textures_; null: none
    std::vector<TextureFilter> filters_;  ///< one per texture
    std::vector<GlSurface> surfaces_, coarse_;
    int most_probes_ = 1;
    std::size_t uploaded_ = 0;  ///< the number of surfaces that are uploaded completely
};

}  // namespace burl
