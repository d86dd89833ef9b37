// A filter's tables are computed once, when the object of a texture's map is made.
#include "procedural/color/filtered_colors.h"

namespace burl {

namespace {

std::variant<MapPieces, ColorMip, ColorSums> prepared(const ColorMap& map, FilterKind kind) {
    switch (kind) {
        case FilterKind::table_mip:
            return ColorMip(map);
        case FilterKind::table_sat:
        case FilterKind::table_sat3:
            return ColorSums(map, kind == FilterKind::table_sat3);
        default:
            return MapPieces(map);
    }
}

}  // namespace

FilteredColors::FilteredColors(const ColorMap& map, FilterKind kind)
    : wrap_(map.wrap),
      both_axes_(kind == FilterKind::trapezoid || kind == FilterKind::trapezoid2),
      map_(prepared(map, kind)) {}

Vec3d FilteredColors::operator()(double f, double slope_u, double slope_v) const {
    const FilterWidths widths = FilterWidths::of(slope_u, slope_v);
    if (const auto* pieces = std::get_if<MapPieces>(&map_))
        return both_axes_ ? trapezoid_filtered(*pieces, f, widths)
                          : box_filtered(*pieces, f, widths.box());
    if (const auto* mip = std::get_if<ColorMip>(&map_)) return (*mip)(f, widths.box());
    return std::get<ColorSums>(map_)(f, widths.box());
}

}  // namespace burl
