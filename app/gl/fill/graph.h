#pragma once
// Synthesis of a texture graph into an atlas in one pass on OpenGL. Solid points come from a point
// map; a shader generated from the graph (procedural/glsl/graph.h) evaluates and encodes each
// texel's colour: at its centre, as the mean over the texel by the nodes' own filters, or as the
// weighted mean of several samples. Where OpenGL has float64 and IEEE 754 rounding, the bytes are
// those of synthesize_graph_rgb8, _rgb16 and _rgbf in float32.
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/gl/fill/synthesize.h"
#include "app/gl/fill/texel_lines.h"
#include "procedural/glsl/graph.h"

namespace burl {

/// The synthesis of graphs in one context, which must outlive it. Programs and point maps are kept
/// between calls.
class GlGraphSynthesis {
  public:
    explicit GlGraphSynthesis(GlContext& context, const GlSynthesisLimits& limits = {});

    /// The reason why a graph cannot be evaluated with a filter; empty where it can.
    std::string problem(const TextureGraph& graph, const Filter& filter = {}) const;

    /// Synthesises the texture as synthesize_graph_rgb8, _rgb16 or _rgbf do; an image of the
    /// atlas's size is overwritten. 0 threads means all. Throws Error: unsupported where problem()
    /// gives a reason, runtime when memory runs out.
    template <class Pixel>
    void synthesize(const SolidAtlas& solid, const TextureGraph& graph,
                    const Affine3& texture_from_atlas, int threads, Image<Pixel>& image,
                    const Filter& filter = {});
    /// Drops everything about the atlas of earlier calls; must be called before it changes or is
    /// destroyed.
    void forget_atlas();

    const GlWork& work() const { return work_; }

  private:
    struct KeptImage {
        std::shared_ptr<const MipImage> pixels;
        GlTexture texture;
    };
    struct KeptPoints {
        GlTile tile;
        GlPointMap points;
    };
    template <class Pixel>
    const GlProgram& program(const GlslTexture& texture, FilterKind kind);
    template <class Pixel>
    void bind_inputs(const GlProgram& program, const GlslTexture& texture,
                     std::span<const GlBufferTexture> tables);
    GlslReal real() const { return float64_ ? GlslReal::float64 : GlslReal::float32; }
    void bind_points(const GlProgram& program, const GlPointMap& map) const;
    void set_lines(const GlTile& tile, int threads);
    void bind_lines(const GlProgram& program, const Filter& filter) const;
    const GlTexture& image_texture(const std::shared_ptr<const MipImage>& pixels);
    void set_atlas(const SolidAtlas& solid, const Affine3& texture_from_atlas, int threads);
    const GlPointMap& points(const GlTile& tile);

    GlContext* context_;
    const GladGLContext* gl_;
    GlSynthesisLimits limits_;
    bool float64_;
    GlFullScreen full_screen_;
    GlTimer timer_;
    std::map<std::string, GlProgram> programs_;  ///< keyed by the text of the fragment shader
    std::optional<GlBufferTexture> codes8_;
    GlColorTables colors_;  ///< the tables of 16-bit codes
    std::vector<KeptImage> images_;
    const SolidAtlas* solid_ = nullptr;
    Affine3 texture_from_atlas_;
    std::optional<GlLatticeMapper> mapper_;
    std::list<KeptPoints> points_;       ///< up to the limit of bytes, and one more
    std::optional<GlTexelLines> lines_;  ///< the atlas's spans, once a filter needs them
    GlReadBack read_back_;
    GlWork work_;
};

}  // namespace burl
