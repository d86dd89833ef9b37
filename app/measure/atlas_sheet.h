#pragma once
// Pictures of an atlas's texels beside its texture: their solid coordinates, their charts and their
// relative scale in false colour (Carr & Hart 2002, figures 5 and 7).
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "app/pipeline/pipeline.h"

namespace burl {

/// The picture's subject. `texture` and `error` (app/measure/texture_error.h) depend on a texture,
/// the others on its atlas alone.
enum class SheetMode : unsigned { texture, solid, charts, scale, error };
inline constexpr std::array<std::string_view, 5> sheet_mode_names{"texture", "solid", "charts",
                                                                  "scale", "error"};

/// An atlas with the values that its pictures show.
struct AtlasSheet {
    SolidAtlas solid;  ///< solid points in the recipe's space
    Box3 box;          ///< the bounding box of the mesh in that space
    /// The chart of each triangle.
    std::vector<std::uint32_t> charts;
    /// Per triangle the relative scale (app/measure/metrics_pictures.h).
    std::vector<double> scales;
};

/// The sheet of the pipeline's atlas.
AtlasSheet atlas_sheet(Pipeline& pipeline);

/// The triangle, chart, relative scale and solid point of a texel.
struct TexelFacts {
    std::uint32_t triangle = 0, chart = 0;
    double scale = 1.0;
    Vec3d point{0.0};  ///< the solid point, in the sheet's space
};
/// The facts of texel (x, y); no value outside the texture and its spans.
std::optional<TexelFacts> texel_facts(const AtlasSheet& sheet, std::int64_t x, std::int64_t y);

/// MIP levels, down to 1 x 1 texel, of the picture for `solid`, `charts` or `scale`, in sRGB codes.
/// A texel of a coarser level shows the value at its centre. Solid coordinates are codes of red,
/// green and blue from 0 to 255 along the longest side of the box.
std::vector<Image<Rgb8>> sheet_levels(const AtlasSheet& sheet, SheetMode mode);

}  // namespace burl
