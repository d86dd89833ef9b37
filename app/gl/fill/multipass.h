#pragma once
// Runs a multipass plan (procedural/passes/plan.h) on OpenGL: a draw over the whole image for
// each pass, images being textures that the next pass reads. Where the papers blended into the
// frame buffer and copied it to a texture, passes read both images and draw a third: so numbers are
// rounded as shaders round, which IEEE 754 settles, and nothing is copied.
#include <map>

#include "app/gl/device/source.h"
#include "app/gl/fill/lattice_map.h"
#include "procedural/numbers/half_float.h"
#include "procedural/passes/plan.h"

namespace burl {

class GlMultipass {
  public:
    /// `float64`: where OpenGL has it, for the field's index. `gl` must outlive it.
    GlMultipass(const GladGLContext& gl, bool float64);

    /// What the calls below belong to, and their images' size. `plan` must outlive them.
    void set_plan(const MultipassPlan& plan, GlSize size);
    /// The programs of all passes, which run() compiles otherwise as they come.
    void compile();
    /// The parts of a shader that reads the images: multipass.glsl and what stands before it.
    ShaderSource source() const;
    /// One map for each stream, at least one; the first has the quadric. Throws Error as GlTarget.
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
    ShaderSource pass_source(const std::string& name) const;

    const GladGLContext* gl_;
    bool float64_;
    GlFullScreen full_screen_;
    const MultipassPlan* plan_ = nullptr;
    GlSize size_{0};
    PassPrecision precision_ = PassPrecision::float32;  ///< of the images there are
    std::map<std::string, GlProgram> programs_;
    std::map<PassImage, GlTarget> images_;
    std::map<bool, GlTarget> spares_;
    std::vector<GlTexture> tables_;
};

/// How this OpenGL rounds what it draws into half floats.
HalfRounding half_rounding(const GladGLContext& gl);

}  // namespace burl
