#pragma once
// Fills an atlas with a texture of the 1999 model (Hart et al. 1999, eq. 1 and 2) in one pass on
// OpenGL: the texels' lattice coordinates come from maps, the noise is evaluated in a generated
// fragment shader (procedural/glsl/field.h), colours are looked up in the host's tables. Where
// OpenGL has float64 and rounds as IEEE 754 says, the bytes are those of host synthesis with
// Kernel::direct.
#include <map>
#include <memory>
#include <string>

#include "app/gl/device/timer.h"
#include "app/gl/fill/fixed_synthesize.h"
#include "app/gl/fill/map_cache.h"
#include "app/gl/fill/map_filter.h"
#include "app/gl/fill/output.h"
#include "procedural/glsl/field.h"

namespace burl {

/// What the last synthesis did; seconds.
struct GlWork {
    int passes = 0;         ///< draws
    int maps = 0;           ///< lattice maps made, not kept from before
    double map = 0.0;       ///< making them
    double compile = 0.0;   ///< shaders, where they are new
    double colors = 0.0;    ///< tables of the colour map, where it is new
    double draw = 0.0;      ///< from the first draw until all is done, by the host's clock
    double gpu = 0.0;       ///< the same by OpenGL's clock; 0: it has none
    double transfer = 0.0;  ///< reading back and packing

    GlWork& operator+=(const GlWork& more);
};

/// Sizes of what is held at a time.
struct GlSynthesisLimits {
    int tile = 2048;                                ///< largest side of a tile, in texels
    std::size_t map_budget = std::size_t(1) << 30;  ///< bytes of maps kept between calls
    bool float64 = true;                            ///< where OpenGL has it
};

/// Keeps programs, tables and maps between calls. The context it works in must outlive it.
class GlSynthesis {
  public:
    explicit GlSynthesis(GlContext& context, const GlSynthesisLimits& limits = {});

    /// Why a texture cannot be made so; empty where it can.
    std::string problem(const Texture& texture, const Filter& filter = {}) const;

    /// As synthesize_rgb8, _rgb16 or _rgbf, for Pixel Rgb8, Rgb16 or RgbF, or as
    /// synthesize_field, unfiltered, for float. An image of the atlas's size is written over.
    /// Throws Error: unsupported where problem() has something to say, runtime when memory runs
    /// out.
    template <class Pixel>
    void synthesize(const SolidAtlas& solid, const Texture& texture,
                    const Affine3& texture_from_atlas, int threads, Image<Pixel>& image,
                    const Filter& filter = {});
    /// The atlas of the calls before is about to change or go away.
    void forget_atlas();

    const GlWork& work() const { return work_; }
    const GlContext& context() const { return *context_; }

  private:
    /// A tile's maps.
    struct Maps {
        std::vector<std::shared_ptr<const GlLatticeMap>> lattices;
        std::vector<std::shared_ptr<const GlPointMap>> points;  ///< of lone octaves
    };
    /// Of the draw of colours at the texels' centres, and of a filter's means: null where there is
    /// none.
    struct Programs {
        const GlProgram *colors = nullptr, *means = nullptr;
    };
    template <class Pixel>
    Programs programs(const FieldShape& shape, bool filtered);
    const GlProgram& compiled(const ShaderSource& source);
    const GlTarget& target(GLenum internal, GlSize size);
    Maps maps_of(const FieldOctaves& octaves, const Quadric& quadric, const GlTile& tile);
    int bind_maps(const GlProgram& program, const Maps& maps) const;
    template <class Pixel>
    void set_up(const FieldOctaves& octaves, const Maps& maps, const GlProgram& program,
                bool filtered, bool means);
    template <class Pixel>
    void draw(const FieldOctaves& octaves, const Quadric& quadric, const Programs& programs,
              const GlTile& tile, bool filtered);
    void set_field(const GlProgram& program, const FieldUniforms& uniforms) const;

    GlContext* context_;
    const GladGLContext* gl_;
    GlSynthesisLimits limits_;
    bool float64_;
    GlFullScreen full_screen_;
    GlTimer timer_;
    GlMapCache maps_;
    GlColorTables colors_;
    GlRealUniforms reals_;
    std::optional<GlFixedSynthesis> fixed_;      ///< where OpenGL is software
    std::optional<GlMapFilter> filter_;          ///< once there is one
    std::map<std::string, GlProgram> programs_;  ///< by the text of the fragment shader
    std::optional<GlTarget> target_;
    GlReadBack read_back_;
    GlWork work_;
};

}  // namespace burl
