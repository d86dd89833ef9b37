#pragma once
// A multipass plan (procedural/passes/plan.h) on OpenGL: one draw over the whole image per pass, in
// which images are textures that later passes read. The papers blended into the frame buffer and
// copied it to a texture; here passes read both images and draw a third. So numbers are rounded as
// shaders round, which IEEE 754 defines, and nothing is copied.
#include <map>

#include "app/gl/device/objects.h"
#include "app/gl/fill/lattice_map.h"
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
    ShaderSource pass_source(const std::string& name) const;

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

}  // namespace burl
