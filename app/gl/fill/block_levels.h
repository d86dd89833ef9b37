#pragma once
// MIP levels of an atlas's texture by OpenGL, as block_levels computes them on the host (Williams,
// "Pyramidal Parametrics", 1983): one pass per level, in which gutters do not count twice.
#include <cstdint>
#include <vector>

#include "app/gl/device/target.h"
#include "atlas/build/block_levels.h"

namespace burl {

/// Computes the MIP levels of textures of one atlas.
class GlBlockLevels {
  public:
    /// Compiles the passes; context and atlas must outlive it. `float32` sums in float32 even where
    /// shaders have float64. Makes the context current. Throws Error(runtime).
    GlBlockLevels(GlContext& context, const MeshAtlas& atlas, bool float32 = false);

    /// Levels 1 to `levels` (at most down to 1 x 1) of a texture of the atlas's size in linear
    /// light. With float64 and IEEE's division and rounding, as in software, they have the bits of
    /// block_levels; with float32 they are within 1e-6 of them, for values up to 1. Textures of
    /// more than `tile` texels a side are processed in tiles through the levels at which their side
    /// is even, so that memory is that of a tile where the side is a multiple of 4096. Throws
    /// Error: unsupported or runtime when the texture does not fit.
    std::vector<Image<RgbF>> operator()(const Image<RgbF>& texture, std::uint32_t levels,
                                        int tile = largest_tile) const;

  private:
    struct Stage;
    void halve(Stage& stage, std::uint32_t level) const;
    void draw(Stage& stage, glm::ivec2 origin, std::uint32_t first, std::uint32_t last,
              std::vector<Image<RgbF>>& levels) const;

    GlContext& context_;
    const MeshAtlas& atlas_;
    bool float64_ = false;
    GlProgram even_, any_;  ///< passes for two even sides, and for all other sizes
    GlFullScreen pass_;
    /// The last level without texels that cover two blocks (last_pure_level).
    std::uint32_t pure_ = 0;
};

}  // namespace burl
