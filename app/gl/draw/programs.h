#pragma once
// The shader programs of scenes: one fragment shader, compiled for the properties of surfaces.
#include <cstdint>
#include <map>
#include <optional>

#include "app/gl/device/objects.h"
#include "app/scene/material.h"

namespace burl {

/// The texture units of a surface's pictures: base colour, normals, and from `first_map_unit` on
/// those of MaterialMap.
inline constexpr int base_color_unit = 0, normal_map_unit = 1, first_map_unit = 6;

/// The shader programs that draw scenes, compiled at their first use and shared by all scenes of a
/// context.
class GlScenePrograms {
  public:
    explicit GlScenePrograms(const GladGLContext& gl) : gl_(gl) {}

    /// The properties that a program is compiled for.
    struct Look {
        bool encoded = false, lit = false, ambient = false, bumped = false, levels = false,
             in_blocks = false, places = false, masks = false, blends = false, layered = false,
             tone = false, coarse = false, anisotropic = false;
        bool sun = false, clearcoat = false, sheen = false, transmits = false, one_orm = false;
        std::uint32_t maps = 0;  ///< bit k: the material has the picture MaterialMap(k)
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
