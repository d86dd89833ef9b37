#pragma once
// Synthesis of a texture into an atlas on OpenGL, tile by tile: a texture graph by the shader of
// app/gl/fill/graph.h, a texture of the 1999 model (Hart et al. 1999, eq. 1 and 2) by one whose
// lattice coordinates come from maps, whose noise is a generated text (procedural/glsl/field.h),
// and whose colours are looked up in the host's tables. Where OpenGL has float64 and IEEE 754
// rounding, the bytes are those of host synthesis in float32, with Kernel::direct.
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/base/stopwatch.h"
#include "app/gl/device/timer.h"
#include "app/gl/fill/graph.h"
#include "app/gl/fill/lattice_map.h"
#include "app/gl/fill/map_filter.h"
#include "app/gl/fill/output.h"
#include "procedural/glsl/field.h"

namespace burl {

/// The work of a synthesis; times in seconds of the host's clock unless stated otherwise.
struct GlWork {
    int passes = 0;         ///< the number of draws
    int maps = 0;           ///< the number of lattice maps made, not found in the cache
    double map = 0.0;       ///< making maps
    double compile = 0.0;   ///< compiling shaders that are new
    double colors = 0.0;    ///< making tables of a colour map that is new
    double draw = 0.0;      ///< drawing, from the first draw until all commands are done
    double gpu = 0.0;       ///< drawing by OpenGL's clock; 0 where it has none
    double transfer = 0.0;  ///< reading back and packing

    GlWork& operator+=(const GlWork& more);
};

/// Limits of memory and precision.
struct GlSynthesisLimits {
    int tile = 2048;                                ///< the largest side of a tile, in texels
    std::size_t map_budget = std::size_t(1) << 30;  ///< the most bytes of maps kept between calls
    bool float64 = true;                            ///< whether to use float64 where OpenGL has it
};

/// The part that all syntheses have in common: programs, which are kept, and the loop over tiles,
/// each drawn into a target and read back.
class GlTileLoop {
  public:
    GlTileLoop(GlContext& context, const GlSynthesisLimits& limits);

    const GladGLContext& gl() const { return context_->gl(); }
    /// Whether shaders use float64.
    bool float64() const { return float64_; }
    const GlFullScreen& full_screen() const { return full_screen_; }
    /// The work since begin().
    GlWork& work() { return work_; }
    const GlWork& work() const { return work_; }

    /// Makes the context current and begins a synthesis. Throws Error(unsupported) with the reason
    /// that problem() returns, unless it is empty.
    template <class Problem>
    void begin(const Problem& problem) {
        context_->make_current();
        if (const std::string why = problem(); !why.empty())
            throw Error(ExitCode::unsupported, why);
        work_ = {};
        if (programs_.size() + 2 > most_programs) programs_.clear();
    }
    /// The program of a fragment shader, which messages call `name`; it is compiled where it is new
    /// and stays until the next begin().
    const GlProgram& program(const std::string& name, const ShaderSource& fragment);
    /// Fills an image of the atlas's size. For every tile ready(tile) makes and binds what its draw
    /// reads, and what it returns is kept until draw(that, tile, target) has drawn the tile into
    /// the bound target; draw() returns the number of passes. 0 threads means all.
    template <class Pixel, class Ready, class Draw>
    void fill(const SolidAtlas& solid, int threads, Image<Pixel>& image, const Ready& ready,
              const Draw& draw) {
        if (image.width() != solid.size || image.height() != solid.size)
            image = Image<Pixel>::unset(solid.size, solid.size);
        for_tiles({int(solid.size), int(solid.size)}, limits_.tile, [&](const GlTile& tile) {
            // The target comes first, since creating a texture changes the bindings.
            const GlTarget& into = target(GlOutput<Pixel>::internal, tile.size);
            const auto inputs = ready(tile);
            into.bind({{0, 0}, tile.size});
            timer_.start();
            work_.passes += draw(inputs, tile, into);
            const GlSeconds seconds = timer_.stop();
            work_.draw += seconds.wall;
            work_.gpu += seconds.gpu;
            timed(work_.transfer, [&] { read_back_.read(into, tile, threads, image); });
        });
    }

  private:
    static constexpr std::size_t most_programs = 64;
    const GlTarget& target(GLenum internal, GlSize size);

    GlContext* context_;
    GlSynthesisLimits limits_;
    bool float64_;
    GlFullScreen full_screen_;
    GlTimer timer_;
    std::map<std::string, GlProgram> programs_;  ///< keyed by the text of the fragment shader
    std::optional<GlTarget> target_;
    GlReadBack read_back_;
    GlWork work_;
};

/// The synthesis in one context, which must outlive it. Programs, tables and maps are kept between
/// calls.
class GlSynthesis {
  public:
    explicit GlSynthesis(GlContext& context, const GlSynthesisLimits& limits = {});

    /// The reason why a texture cannot be made with a filter; empty where it can.
    std::string problem(const Texture& texture, const Filter& filter = {}) const;
    std::string problem(const TextureGraph& graph, const Filter& filter = {}) const {
        return graph_.problem(graph, filter);
    }

    /// Synthesises the texture as synthesize_model does, for Pixel Rgb8, Rgb16 or RgbF, or as
    /// synthesize_field does, unfiltered, for float. An image of the atlas's size is
    /// overwritten. 0 threads means all. Throws Error: unsupported where problem() gives a reason,
    /// runtime when memory runs out.
    template <class Pixel>
    void synthesize(const SolidAtlas& solid, const Texture& texture,
                    const Affine3& texture_from_atlas, int threads, Image<Pixel>& image,
                    const Filter& filter = {});
    /// Synthesises the graph as synthesize_graph_rgb8, _rgb16 or _rgbf do, for Pixel Rgb8, Rgb16 or
    /// RgbF. Throws Error as for textures.
    template <class Pixel>
    void synthesize(const SolidAtlas& solid, const TextureGraph& graph,
                    const Affine3& texture_from_atlas, int threads, Image<Pixel>& image,
                    const Filter& filter = {});
    /// Drops everything about the atlas of earlier calls; must be called before it changes or is
    /// destroyed.
    void forget_atlas();

    const GlWork& work() const { return tiles_.work(); }

  private:
    /// The maps of a tile.
    struct Maps {
        std::vector<std::shared_ptr<const GlLatticeMap>> lattices;
        /// The point maps of octaves without a stream kernel.
        std::vector<std::shared_ptr<const GlPointMap>> points;
    };
    /// The programs for the draw of colours at the texels' centres, and for that of a filter's
    /// means; null where there is no such draw.
    struct Programs {
        const GlProgram *colors = nullptr, *means = nullptr;
    };
    template <class Pixel>
    Programs programs(const FieldShape& shape, bool filtered);
    Maps maps_of(const FieldOctaves& octaves, const Quadric& quadric, const GlTile& tile);
    int bind_maps(const GlProgram& program, const Maps& maps) const;
    template <class Pixel>
    void set_up(const FieldOctaves& octaves, const Maps& maps, const GlProgram& program,
                bool filtered, bool means);
    void set_field(const GlProgram& program, const FieldUniforms& uniforms) const;

    GlTileLoop tiles_;
    const GladGLContext* gl_;
    std::size_t budget_;  ///< the most bytes of maps kept between calls
    bool float64_;
    GlMapCache maps_;
    GlColorTables colors_;
    std::optional<GlMapFilter> filter_;  ///< created at the first filter
    GlGraphPass graph_;
};

}  // namespace burl
