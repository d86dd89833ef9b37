#pragma once
// The programs that draw scenes: compiled once, when they are first wanted, for all scenes of a
// context.
#include <map>
#include <optional>

#include "app/gl/device/objects.h"

namespace burl {

class GlScenePrograms {
  public:
    explicit GlScenePrograms(const GladGLContext& gl) : gl_(gl) {}

    /// What the program that draws a surface is made for.
    struct Look {
        bool encoded = false, lit = false, bumped = false, levels = false, in_blocks = false,
             places = false;
        auto operator<=>(const Look&) const = default;
    };
    /// The program that draws so, in use.
    const GlProgram& use(const Look& look);
    /// The one that draws what is looked up (app/gl/draw/view_texels.h), in use.
    const GlProgram& use_lookups();

  private:
    const GladGLContext& gl_;
    std::optional<GlProgram> lookups_;
    std::map<Look, GlProgram> looks_;
};

}  // namespace burl
