#pragma once
// The fastest way that software OpenGL has to make 8-bit colours of a 1999 texture, with the host's
// bytes: a draw without float64 and with little memory to read (procedural/glsl/fixed_index.h),
// which leaves the few texels open whose index lies too near to a change of the colours; the host
// works these out. At 1024 x 1024 they are a dozen.
#include <map>
#include <optional>
#include <string>

#include "app/gl/device/source.h"
#include "app/gl/device/timer.h"
#include "app/gl/fill/site_maps.h"
#include "procedural/glsl/fixed_index.h"

namespace burl {

struct GlWork;

/// Keeps programs, tables and maps between calls.
class GlFixedSynthesis {
  public:
    /// Tiles of at most `tile` texels a side; at most `budget` bytes of maps are kept.
    GlFixedSynthesis(const GladGLContext& gl, int tile, std::size_t budget);

    /// As synthesize_rgb8 with Kernel::direct, and adds to `work` what it did. The image has the
    /// atlas's size. False, and the image undefined, where the texture is none of those that fixed
    /// point serves: noise without a hash (simplex, Worley, periods, shapes), more octaves than
    /// fragments have inputs, huge quadrics, or more open texels than are worth it.
    bool synthesize(const SolidAtlas& solid, const Texture& texture,
                    const Affine3& texture_from_atlas, int threads, Image<Rgb8>& image,
                    GlWork& work);
    /// The atlas of the calls before is about to change or go away.
    void forget_atlas() { maps_.forget_atlas(); }
    /// Nobody asked for the maps.
    void drop_unused() { maps_.drop_unused(); }

    /// Texels of the last synthesis that the host worked out.
    std::size_t undecided() const { return undecided_.size(); }

  private:
    struct Colors {
        ColorMap map;
        ColorTable8 table;
        std::optional<FixedColors> fixed;  ///< without entries
        std::optional<GlBufferTexture> entries;
    };
    struct Maps {
        GlSiteMaps::Map bases;
        std::vector<GlSiteMaps::Map> sites;
    };
    void set_colors(const ColorMap& map);
    bool fits(const FixedShape& shape) const;
    const GlProgram& program(const FixedShape& shape, GlWork& work);
    std::optional<Maps> maps_of(const FixedIndex& index, const Quadric& quadric,
                                const GlTile& tile);
    void draw(const GlProgram& program, const FixedIndex& index, const Maps& maps,
              const GlTile& tile, GlWork& work);
    void read_back(const GlTile& tile, Image<Rgb8>& image);

    const GladGLContext* gl_;
    int tile_;
    GlFullScreen full_screen_;
    GlTimer timer_;
    GlSiteMaps maps_;
    std::optional<Colors> colors_;
    std::map<std::string, GlProgram> programs_;  ///< by the text of the fragment shader
    std::optional<GlTarget> target_;
    std::vector<std::uint32_t> strip_;
    std::vector<glm::uvec2> undecided_;
};

}  // namespace burl
