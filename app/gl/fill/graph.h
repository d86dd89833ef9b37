#pragma once
// Texture graphs on OpenGL: a shader generated from the graph (procedural/glsl/graph.h) evaluates
// each texel's colour at its centre, as the mean over the texel by the nodes' own filters, or as
// the weighted mean of several samples. Solid points come from a point map, or from the texels'
// spans.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/gl/fill/lattice_map.h"
#include "app/gl/fill/output.h"
#include "procedural/glsl/graph.h"

namespace burl {

/// The shaders of graphs and what they read.
class GlGraphPass {
  public:
    /// `budget` limits, in bytes, the point maps and, once more, the spans that are kept between
    /// calls. Without `float64` numbers are float32.
    GlGraphPass(const GladGLContext& gl, bool float64, std::size_t budget);

    /// The reason why a graph cannot be evaluated with a filter; empty where it can.
    std::string problem(const TextureGraph& graph, const Filter& filter) const;

    /// Sets the atlas, the graph and the filter of the following calls, makes the textures that the
    /// graph reads, and returns its fragment shader. 0 threads means all.
    template <class Pixel>
    ShaderSource set(const SolidAtlas& solid, const TextureGraph& graph,
                     const Affine3& texture_from_atlas, int threads, const Filter& filter);
    /// Sets the same for a whole material, unfiltered where has_glsl_planes(), and returns a shader
    /// that ends with what `outputs` returns for the expression of a texel's base colour; it may
    /// call `uint srgb8(real)`, solid_point() where the filter is none, and what glsl_material()
    /// defines. A filtered one has no height.
    ShaderSource set_material(const SolidAtlas& solid, const TextureGraph& graph,
                              const TextureGraph& height, const Affine3& texture_from_atlas,
                              const Filter& filter,
                              const std::function<std::string(const std::string&)>& outputs);
    /// Sets the tile of the next draw: makes its point map or its spans where they are not kept.
    /// Returns the point map; null where the filter reads spans.
    std::shared_ptr<const GlPointMap> set_tile(const GlTile& tile);
    /// Binds the textures and sets the uniforms of a program in use.
    template <class Pixel>
    void bind(const GlProgram& program, const GlPointMap* points);
    /// Drops the graph's textures, and point maps that it did not use.
    void finish();
    /// Drops everything about the atlas; must be called before it changes or is destroyed.
    void forget_atlas();
    /// The number of point maps made so far, rather than kept.
    int made() const { return points_.made(); }

  private:
    struct KeptImage {
        std::shared_ptr<const MipImage> pixels;
        GlTexture texture;
    };
    void set_atlas(const SolidAtlas& solid, const Affine3& texture_from_atlas, int threads,
                   const Filter& filter);
    void make_inputs();
    GlslReal real() const { return float64_ ? GlslReal::float64 : GlslReal::float32; }
    const GlTexture& image_texture(const std::shared_ptr<const MipImage>& pixels);

    const GladGLContext* gl_;
    bool float64_;
    std::optional<GlBufferTexture> codes8_;
    GlColorTables colors_;  ///< the tables of 16-bit codes
    GlslTexture texture_;
    Filter filter_;
    std::vector<KeptImage> images_;
    std::vector<GlBufferTexture> tables_;  ///< those of texture_
    const SolidAtlas* solid_ = nullptr;
    Affine3 texture_from_atlas_;
    int threads_ = 0;
    GlMapCache points_;
    GlTexelLines lines_;
    bool lines_known_ = false;  ///< whether lines_ holds the atlas
};

}  // namespace burl
