#pragma once
// A recipe's pictures made where they are shown: OpenGL textures with all MIP levels, for another
// context that shares them. One draw fills the base colour and the pictures of the material's
// channels together, so that what they share is evaluated once, and the normal map of bumps; paint
// lies over the base colour.
// Shaders compute in float32, as graphics processors are built for: codes are the host's to one.
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/gl/fill/graph.h"
#include "app/gl/fill/multipass.h"
#include "app/paint/layer.h"
#include "app/recipe/recipe.h"
#include "procedural/fill/normals.h"
#include "procedural/fill/pictures.h"

namespace burl {

/// Square textures with all MIP levels, trilinear and clamped to their edges. Colours are sRGB.
struct GlPictures {
    int side = 0;  ///< texels a side
    /// The base colour, then one per plan, then the normal map of bumps if there is one.
    std::vector<GlTexture> images;
    std::vector<bool> is_color;
};

/// Textures in turn: one that nobody shows any more is drawn again.
class GlPicturePool {
  public:
    explicit GlPicturePool(const GladGLContext& gl) : gl_(&gl) {}
    /// Textures of this side that nobody else refers to.
    std::shared_ptr<GlPictures> take(int side, const std::vector<bool>& is_color);

  private:
    const GladGLContext* gl_;
    std::vector<std::shared_ptr<GlPictures>> kept_;
};

/// The colour paint of a recipe in a texture, of which only tiles that strokes reached are
/// uploaded.
class GlPaint {
  public:
    explicit GlPaint(const GladGLContext& gl) : gl_(&gl) {}
    /// Brings the texture up to the strokes, at least one; premultiplied linear light and alpha.
    const GlTexture& show(const SolidAtlas& solid, std::span<const PaintStroke> strokes);
    void forget_atlas();

  private:
    const GladGLContext* gl_;
    std::optional<PaintLayer> layer_;
    std::optional<GlTexture> texture_;
};

/// The maker of pictures in one context, which must be current in every call and outlive it.
/// Recipes that differ in numbers alone share a program, so that a slider compiles nothing.
class GlPictureMaker {
  public:
    explicit GlPictureMaker(GlContext& context);

    /// The reason why the pictures cannot be made, as a clause; empty where they can.
    std::string problem(const Recipe& recipe) const;
    /// Whether the normal map of the recipe's bumps can be made besides.
    bool makes_bumps(const Recipe& recipe) const;
    /// Sets the atlas's tangent frames, which bumps need, until it is forgotten.
    void set_frames(const FrameMaps& frames);
    bool has_frames() const { return frames_.has_value(); }
    /// Makes the base colour, the pictures of `plans` and, with frames, the normal map where
    /// makes_bumps(); all commands are done at the end. Throws Error: unsupported where problem()
    /// gives a reason, runtime when memory runs out.
    std::shared_ptr<const GlPictures> make(const SolidAtlas& solid, const Recipe& recipe,
                                           const std::vector<PicturePlan>& plans);
    /// Drops everything about the atlas; must be called before it changes or is destroyed.
    void forget_atlas();
    /// The number of programs that it has compiled and keeps.
    std::size_t programs() const { return programs_.size(); }

  private:
    /// A program, and the numbers of one recipe for it.
    struct Material {
        const GlProgram* program;
        std::vector<Vec4f> numbers;
    };
    Material material(const Recipe& recipe, const std::vector<PicturePlan>& plans,
                      const SolidAtlas& solid);
    bool draws_bumps(const Recipe& recipe) const { return frames_ && makes_bumps(recipe); }
    void bind_inputs(const GlProgram& program, const GlTexture* paint) const;
    void draw(const GlPictures& into, const Material& material, const GlTexture* paint);

    const GladGLContext* gl_;
    GlGraphPass graph_;
    GlFullScreen pass_;
    GlFramebufferName framebuffer_;
    GlPicturePool pool_;
    struct Frames {
        GlTexture normals, tangents;
    };
    GlPaint paint_;
    std::optional<Frames> frames_;
    /// Keyed by the text of the fragment shader, without its numbers.
    std::map<std::string, GlProgram> programs_;
};

/// A pass of the papers' multipass noise, as a number from 1 on.
struct ShownPass {
    std::size_t number = 0, count = 0;
    std::string words;  ///< what it does, such as "weigh: corner"; "colour" for the last one
};

/// The maker of textures by the papers' passes, of which one can be looked at alone, in one
/// context, which must be current in every call and outlive it.
class GlPassMaker {
  public:
    explicit GlPassMaker(GlContext& context);

    /// The reason why the passes cannot make the recipe's texture; empty where they can.
    std::string problem(const Recipe& recipe) const;
    /// Makes the texture after `count` passes, or the finished one where there are fewer, of at
    /// most largest_tile texels a side; all commands are done at the end. Throws Error as
    /// GlPictureMaker does.
    std::shared_ptr<const GlPictures> make(const SolidAtlas& solid, const Recipe& recipe,
                                           std::size_t count);
    const ShownPass& shown() const { return shown_; }
    void forget_atlas() { passes_.forget_atlas(); }

  private:
    const GladGLContext* gl_;
    GlMultipassSynthesis passes_;
    GlFramebufferName framebuffer_;
    GlPicturePool pool_;
    ShownPass shown_;
};

/// The texels of the base colour in host memory.
Image<Rgb8> read_texels(const GladGLContext& gl, const GlPictures& pictures);

/// Draws all MIP levels below level 0 of a texture by OpenGL, in linear light where it is sRGB.
void make_levels(const GladGLContext& gl, const GlTexture& texture);

}  // namespace burl
