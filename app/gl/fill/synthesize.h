#pragma once
// Synthesis of a texture of the 1999 model (Hart et al. 1999, eq. 1 and 2) into an atlas in one
// pass on OpenGL: lattice coordinates come from maps, a generated fragment shader
// (procedural/glsl/field.h) evaluates the noise, and colours are looked up in the host's tables.
// Where OpenGL has float64 and IEEE 754 rounding, the bytes are those of host synthesis with
// Kernel::direct.
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/gl/device/timer.h"
#include "app/gl/fill/map_cache.h"
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

/// The synthesis in one context, which must outlive it. Programs, tables and maps are kept between
/// calls.
class GlSynthesis {
  public:
    explicit GlSynthesis(GlContext& context, const GlSynthesisLimits& limits = {});

    /// The reason why a texture cannot be made with a filter; empty where it can.
    std::string problem(const Texture& texture, const Filter& filter = {}) const;

    /// Synthesises the texture as synthesize_rgb8, _rgb16 or _rgbf do, for Pixel Rgb8, Rgb16 or
    /// RgbF, or as synthesize_field does, unfiltered, for float. An image of the atlas's size is
    /// overwritten. 0 threads means all. Throws Error: unsupported where problem() gives a reason,
    /// runtime when memory runs out.
    template <class Pixel>
    void synthesize(const SolidAtlas& solid, const Texture& texture,
                    const Affine3& texture_from_atlas, int threads, Image<Pixel>& image,
                    const Filter& filter = {});
    /// Drops everything about the atlas of earlier calls; must be called before it changes or is
    /// destroyed.
    void forget_atlas();

    const GlWork& work() const { return work_; }
    const GlContext& context() const { return *context_; }

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
    std::optional<GlMapFilter> filter_;          ///< created at the first filter
    std::map<std::string, GlProgram> programs_;  ///< keyed by the text of the fragment shader
    std::optional<GlTarget> target_;
    GlReadBack read_back_;
    GlWork work_;
};

}  // namespace burl
