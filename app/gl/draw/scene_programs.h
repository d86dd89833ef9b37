#pragma once
// The shader programs that draw scenes, compiled at their first use and shared by all scenes of a
// context.
#include <map>
#include <optional>

#include "app/gl/device/objects.h"

namespace burl {

class GlScenePrograms {
  public:
    explicit GlScenePrograms(const GladGLContext& gl) : gl_(gl) {}

    /// The properties that a program is compiled for.
    struct Look {
        bool encoded = false, lit = false, bumped = false, levels = false, in_blocks = false,
             places = false;
        auto operator<=>(const Look&) const = default;
    };
    /// Makes the program of these properties current; compiles it at its first use.
    const GlProgram& use(const Look& look);
    /// Makes the program current that draws lookups (app/gl/draw/view_texels.h).
    const GlProgram& use_lookups();

  private:
    const GladGLContext& gl_;
    std::optional<GlProgram> lookups_;
    std::map<Look, GlProgram> looks_;
};

}  // namespace burl
