#pragma once
// MIP levels of an atlas's texture on the graphics processor: what block_levels does on the host
// (Williams, "Pyramidal Parametrics", 1983), one pass a level, so that gutters never count twice.
#include <cstdint>
#include <vector>

#include "app/gl/device/source.h"
#include "app/gl/device/target.h"
#include "atlas/build/block_levels.h"

namespace burl {

class GlBlockLevels {
  public:
    /// Compiles the passes; both must outlive it. `float32`: sums in float32 even where shaders
    /// have float64. The context becomes current. Throws Error(runtime).
    GlBlockLevels(GlContext& context, const MeshAtlas& atlas, bool float32 = false);

    /// Levels 1 to `levels` (at most down to 1 x 1) of a texture of the atlas's size in linear
    /// light. With float64 and IEEE's division and rounding, as in software, they are
    /// block_levels' own bits; with float32 within 1e-6 of them, for values up to 1.
    /// Textures of more than `tile` texels a side go in tiles through the levels that their size
    /// halves without rest, so that memory is that of a tile where the side is a multiple of 4096.
    /// Throws Error: unsupported or runtime when the texture does not fit.
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
    GlProgram even_, any_;  ///< for two even sides, for others
    GlFullScreen pass_;
    std::uint32_t pure_ = 0;
};

}  // namespace burl
