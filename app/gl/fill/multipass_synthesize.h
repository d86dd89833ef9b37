#pragma once
// Synthesis of a texture of the 1999 model into an atlas by the papers' passes on OpenGL (Carr &
// Hart 2001, section 5.2): lattice maps, then the passes of procedural/passes/plan.h octave by
// octave, then the colour map. At 32f the colour map's index agrees with the host's to 2e-6 (for a
// sum of amplitudes up to 1); 16f and 8 are limited by the images' precision.
#include "app/gl/fill/multipass.h"
#include "app/gl/fill/synthesize.h"

namespace burl {

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
    /// Drops everything about the atlas of earlier calls; must be called before it changes or is
    /// destroyed.
    void forget_atlas() { maps_.forget_atlas(); }

    /// The work of the last synthesis. Its passes are those of noise, index and colour, without
    /// fills.
    const GlWork& work() const { return work_; }
    /// The octaves of the last synthesis, with the bits of their coordinates.
    const std::vector<MultipassOctave>& octaves() const { return octaves_; }
    const MultipassOptions& options() const { return options_; }
    const GlContext& context() const { return *context_; }

  private:
    using Maps = std::vector<std::shared_ptr<const GlLatticeMap>>;

    void make_plan(const SolidAtlas& solid, const Texture& texture,
                   const Affine3& texture_from_atlas);
    Maps maps_of(const Quadric& quadric, const GlTile& tile);
    template <class Pixel>
    void compile();
    template <class Pixel>
    void draw(const Quadric& quadric, const GlTile& tile);
    template <class Pixel>
    void draw_colors(const GlTile& tile);

    GlContext* context_;
    const GladGLContext* gl_;
    MultipassOptions options_;
    GlSynthesisLimits limits_;
    bool float64_;
    GlFullScreen full_screen_;
    GlTimer timer_;
    GlMapCache maps_;
    GlColorTables colors_;
    GlMultipass passes_;
    std::vector<OctaveGroup> groups_;
    std::vector<MultipassOctave> octaves_;
    MultipassPlan plan_;
    std::map<std::string, GlProgram> programs_;  ///< the colour passes, keyed by their text
    const GlProgram* color_program_ = nullptr;
    std::optional<GlTarget> target_;
    GlReadBack read_back_;
    GlWork work_;
};

}  // namespace burl
