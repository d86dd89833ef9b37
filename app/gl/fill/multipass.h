#pragma once
// Synthesis of a texture of the 1999 model into an atlas by the papers' passes on OpenGL (Carr &
// Hart 2001, section 5.2): lattice maps, then the passes of procedural/passes/plan.h octave by
// octave, then the colour map. Each pass is one draw over the whole image, and images are textures
// that later passes read. The papers blended into the frame buffer and copied it to a texture; here
// passes read both images and draw a third. So numbers are rounded as shaders round, which IEEE 754
// defines, and nothing is copied. At 32f the colour map's index agrees with the host's to 2e-6 (for
// a sum of amplitudes up to 1); 16f and 8 are limited by the images' precision.
#include <functional>
#include <map>
#include <optional>

#include "app/gl/fill/lattice_map.h"
#include "app/gl/fill/synthesize.h"
#include "procedural/passes/plan.h"

namespace burl {

/// The images and programs of a multipass plan.
class GlMultipass {
  public:
    /// `float64` is used, where OpenGL has it, for the field's index. `gl` must outlive it.
    GlMultipass(const GladGLContext& gl, bool float64);

    /// Sets the plan of the following calls, which must outlive them, and the images' size.
    void set_plan(const MultipassPlan& plan, GlSize size);
    /// Compiles the programs of all passes; run() would compile each at its first use.
    void compile();
    /// The parts of a shader that reads the images: multipass.glsl and the parts it needs.
    ShaderSource source() const;
    /// Runs the passes. `maps` holds one lattice map per stream, at least one; the first has the
    /// quadric. Throws Error as GlTarget does.
    void run(std::span<const GlLatticeMap* const> maps, std::span<const Pass> passes);
    const GlTarget& image(PassImage image) const { return images_.at(image); }

  private:
    const GlProgram& program(PassKind kind, bool integers);
    GlTarget& target(PassImage image);
    GlTarget& spare(bool integers);
    void run(std::span<const GlLatticeMap* const> maps, const Pass& pass);
    void set_uniforms(const GlProgram& program, const Pass& pass) const;
    void bind_sources(const GlProgram& program, const GlLatticeMap& map, const Pass& pass);
    void upload_tables();
    ShaderSource pass_source(const std::string& name, bool integers) const;

    const GladGLContext* gl_;
    bool float64_;
    GlFullScreen full_screen_;
    const MultipassPlan* plan_ = nullptr;
    GlSize size_{0};
    PassPrecision precision_ = PassPrecision::float32;  ///< the precision of images_
    std::map<std::string, GlProgram> programs_;
    std::map<PassImage, GlTarget> images_;
    std::map<bool, GlTarget> spares_;
    std::vector<GlTexture> tables_;
};

/// The synthesis by passes in one context, which must outlive it. Programs, tables, images and maps
/// are kept between calls.
class GlMultipassSynthesis {
  public:
    GlMultipassSynthesis(GlContext& context, const MultipassOptions& options,
                         const GlSynthesisLimits& limits = {});

    /// The reason why a texture cannot be made, as a clause; empty where it can.
    std::string problem(const Texture& texture) const;

    /// Synthesises the texture as GlSynthesis does, without filters; for Pixel float, the index of
    /// the colour map, in [0,1]. Throws Error(unsupported) where problem() gives a reason.
    template <class Pixel>
    void synthesize(const SolidAtlas& solid, const Texture& texture,
                    const Affine3& texture_from_atlas, int threads, Image<Pixel>& image);
    /// Runs the first `count` passes that draw, or all with the colour's where there are fewer,
    /// over the whole texture, and draws what the last one made into the bound framebuffer through
    /// `begin`, which is called right before that draw: colours as sRGB codes from 0 to 1, numbers
    /// from 0 to 1 as they are, signed ones about 1/2, whole numbers by their lower 8 bits. Returns
    /// the pass; none for the colour's. Throws Error as synthesize() does.
    std::optional<Pass> show(const SolidAtlas& solid, const Texture& texture,
                             const Affine3& texture_from_atlas, std::size_t count,
                             const std::function<void()>& begin);
    /// The number of passes of the last synthesis or show that draw, the colour's included.
    std::size_t passes() const { return count_passes(plan_.passes) + 1; }
    /// Drops everything about the atlas of earlier calls; must be called before it changes or is
    /// destroyed.
    void forget_atlas() { maps_.forget_atlas(); }

    /// The work of the last synthesis. Its passes are those of noise, index and colour, without
    /// fills.
    const GlWork& work() const { return tiles_.work(); }
    /// The octaves of the last synthesis, with the bits of their coordinates.
    const std::vector<MultipassOctave>& octaves() const { return octaves_; }
    const MultipassOptions& options() const { return options_; }

  private:
    using Maps = std::vector<std::shared_ptr<const GlLatticeMap>>;

    void make_plan(const SolidAtlas& solid, const Texture& texture,
                   const Affine3& texture_from_atlas);
    Maps maps_of(const Quadric& quadric, const GlTile& tile);
    void draw_image(const Pass& pass, const std::function<void()>& begin);
    void draw_colors(const std::function<void()>& begin);

    GlTileLoop tiles_;
    MultipassOptions options_;
    GlMapCache maps_;
    GlColorTables colors_;
    GlMultipass passes_;
    std::vector<OctaveGroup> groups_;
    std::vector<MultipassOctave> octaves_;
    MultipassPlan plan_;
};

}  // namespace burl
