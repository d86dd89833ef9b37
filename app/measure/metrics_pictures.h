#pragma once
// Pictures of an atlas: its charts in random colours and its relative scale in false colour, in the
// atlas and on the model (Carr & Hart 2002, figures 5 and 7), and the texture's MIP levels side by
// side, as texels and on the model (figure 8).
#include "app/scene/camera.h"
#include "atlas/measure/lookup_errors.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

/// The subject of a picture; `mesh` is the one whose triangles the atlas places.
struct PicturedAtlas {
    const Mesh& mesh;
    const Atlas& atlas;
    const SolidAtlas& solid;  ///< solid points in any space
    View view;
    double crease_degrees = 40.0;
};

/// The charts in one colour each (`charts`: chart per triangle): the atlas on the left, the model
/// on the right, each a square with the texture's side, clamped to 256..1024 pixels. Texels outside
/// all spans are dark.
Image<Rgb8> charts_picture(const PicturedAtlas& what, std::span<const std::uint32_t> charts);

/// The triangles in the false colour of their relative scale, sqrt(A(u) / A(x) sum A(x)), in the
/// layout of charts_picture().
Image<Rgb8> scale_picture(const PicturedAtlas& what);

/// MIP levels 0 to 6, or as many as there are, in tiles of 256 x 256 pixels: above the level's
/// texels, below the unlit model with bilinear lookups in that level. Where `sharp`, levels are
/// sharpened (atlas/base/sharp_level.h).
Image<Rgb8> levels_picture(const PicturedAtlas& what, const TextureValues& texture,
                           bool sharp = false);

/// The relative scale of each triangle; 1 where it has no area on the surface.
std::vector<double> relative_scales(const Mesh& mesh, const Atlas& atlas);

/// A bright colour for a chart, in linear light: hues by the golden section, so that consecutive
/// ones differ.
Vec3d chart_color(std::uint32_t chart);
/// The colour of texels outside all spans, in linear light.
inline constexpr Vec3d gap_color(0.015, 0.015, 0.015);
/// Linear light as 8-bit sRGB codes; values outside [0,1] are clamped.
Rgb8 encoded(const Vec3d& linear);

/// A colour in linear light by the scale's logarithm: blue at 1/2 and below, white at 1, red at 2
/// and above.
Vec3d scale_color(double relative_scale);

}  // namespace burl
