#pragma once
// What the texels of an atlas stand for, as pictures beside the texture: their solid coordinates,
// their charts and their relative scale in false colour (Carr & Hart 2002, figures 5 and 7).
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "app/pipeline/pipeline.h"

namespace burl {

/// `texture` and `error` (app/measure/texture_error.h) are of a texture, the others of its atlas
/// alone.
enum class SheetMode : unsigned { texture, solid, charts, scale, error };
inline constexpr std::array<std::string_view, 5> sheet_mode_names{"texture", "solid", "charts",
                                                                  "scale", "error"};

struct AtlasSheet {
    SolidAtlas solid;  ///< in the recipe's space
    Box3 box;          ///< of the mesh's points there
    std::vector<std::uint32_t> charts;
    std::vector<double> scales;  ///< relative (app/measure/metrics_pictures.h); both per triangle
};

AtlasSheet atlas_sheet(Pipeline& pipeline);

/// What a texel shows.
struct TexelFacts {
    std::uint32_t triangle = 0, chart = 0;
    double scale = 1.0;
    Vec3d point{0.0};  ///< in the sheet's space
};
/// Empty for a texel of nothing, or of no texture.
std::optional<TexelFacts> texel_facts(const AtlasSheet& sheet, std::int64_t x, std::int64_t y);

/// `solid`, `charts` or `scale` in sRGB codes, level 0 to the one of 1 x 1 texel; a texel of a
/// coarser level shows what lies at its centre. Coordinates are codes of red, green and blue from 0
/// to 255 along the longest side of the box.
std::vector<Image<Rgb8>> sheet_levels(const AtlasSheet& sheet, SheetMode mode);

}  // namespace burl
