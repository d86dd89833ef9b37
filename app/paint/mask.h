#pragma once
// A layer of paint as a mask: how far its strokes cover the points of the surface, whatever their
// colour, as the alpha of paint laid over nothing.
#include <span>
#include <stop_token>
#include <vector>

#include "app/paint/brush.h"
#include "atlas/solid/solid_atlas.h"
#include "atlas/solid/texel_field.h"

namespace burl {

/// The coverage, 0..1, by strokes at all texels of an atlas, 0 for texels that show nothing, with
/// its gradients in the SolidAtlas's space if `slopes`. 0 threads means all; the result does not
/// depend on the number. Once `stop` is requested it must not be used.
TexelField paint_mask(const SolidAtlas& solid, std::span<const PaintStroke> strokes, bool slopes,
                      int threads, const std::stop_token& stop = {});

/// The coverage by strokes at points of solid space, with its gradients. No edge is widened to a
/// texel.
std::vector<Dual> paint_mask_at(std::span<const Vec3d> points,
                                std::span<const PaintStroke> strokes);

}  // namespace burl
