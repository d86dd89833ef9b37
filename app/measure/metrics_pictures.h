#pragma once
// Pictures of an atlas: its charts in random colours and its relative scale in false colour, in the
// atlas and on the model (Carr & Hart 2002, figures 5 and 7), and the texture's MIP levels side by
// side, as texels and on the model (figure 8).
#include "app/scene/camera.h"
#include "atlas/measure/lookup_errors.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

/// What is drawn: `mesh` is the one whose triangles the atlas places.
struct PicturedAtlas {
    const Mesh& mesh;
    const Atlas& atlas;
    const SolidAtlas& solid;  ///< of any space
    View view;
    double crease_degrees = 40.0;
};

/// The atlas on the left, the model on the right, each as high as the texture is, 256 to 1024
/// pixels. A colour per chart (`charts`: chart per triangle); texels that show no triangle are
/// dark.
Image<Rgb8> charts_picture(const PicturedAtlas& what, std::span<const std::uint32_t> charts);

/// The same in the false colour of each triangle's own relative scale, sqrt(A(u) / A(x) sum A(x)).
Image<Rgb8> scale_picture(const PicturedAtlas& what);

/// Levels 0 to 6, or as many as there are: above the level's texels, below the model with plain
/// bilinear lookups in it, without light. Tiles are 256 pixels wide.
Image<Rgb8> levels_picture(const PicturedAtlas& what, const TextureValues& texture);

/// Each triangle's own relative scale; 1 where it has no area on the surface.
std::vector<double> relative_scales(const Mesh& mesh, const Atlas& atlas);

/// A bright colour of its own, linear light: hues by the golden section, so that consecutive ones
/// differ.
Vec3d chart_color(std::uint32_t chart);
/// What texels that show no triangle have, linear light.
inline constexpr Vec3d gap_color(0.015, 0.015, 0.015);
/// Linear light in 8 bits of sRGB.
Rgb8 encoded(const Vec3d& linear);

/// Blue at 1/2 and below, white at 1, red at 2 and above, by the logarithm; linear light.
Vec3d scale_color(double relative_scale);

}  // namespace burl
