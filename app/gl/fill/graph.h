#pragma once
// Fills an atlas with a texture graph in one pass on OpenGL: every texel's point comes from a point
// map, a shader generated from the graph (procedural/glsl/graph.h) works out its colour and encodes
// it, its mean over the texel by the nodes' own filters, or the weighted mean of its colours at
// several places in the texel. Where OpenGL has float64
// and rounds as IEEE 754 says, the bytes are those of synthesize_graph_rgb8 and its like in
// float32.
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

/// Keeps programs and points between calls. The context it works in must outlive it.
class GlGraphSynthesis {
  public:
    explicit GlGraphSynthesis(GlContext& context, const GlSynthesisLimits& limits = {});

    /// Why a graph cannot be evaluated with a filter; empty where it can.
    std::string problem(const TextureGraph& graph, const Filter& filter = {}) const;

    /// As synthesize_graph_rgb8, _rgb16 or _rgbf. An image of the atlas's size is written over.
    /// Throws Error: unsupported where problem() has something to say, runtime when memory runs
    /// out.
    template <class Pixel>
    void synthesize(const SolidAtlas& solid, const TextureGraph& graph,
                    const Affine3& texture_from_atlas, int threads, Image<Pixel>& image,
                    const Filter& filter = {});
    /// The atlas of the calls before is about to change or go away.
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
    std::map<std::string, GlProgram> programs_;  ///< by the text of the fragment shader
    std::optional<GlBufferTexture> codes8_;
    GlColorTables colors_;  ///< for 16-bit codes
    std::vector<KeptImage> images_;
    const SolidAtlas* solid_ = nullptr;
    Affine3 texture_from_atlas_;
    std::optional<GlLatticeMapper> mapper_;
    std::list<KeptPoints> points_;       ///< as many as the limit allows, and one
    std::optional<GlTexelLines> lines_;  ///< of the atlas, once a filter needs them
    GlRealUniforms reals_;
    GlReadBack read_back_;
    GlWork work_;
};

}  // namespace burl
