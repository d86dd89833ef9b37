#pragma once
// What a surface reflects of white light from all sides, by the angle of the view: the second of
// the two sums of Karis, "Real Shading in Unreal Engine 4", 2013, and the same of sheen.
#include "atlas/base/image.h"
#include "atlas/base/vec.h"

namespace burl {

/// The table, 64 x 64: column x is for n.v = x / 63, row y for perceptual roughness y / 63, so that
/// a texture unit looks it up at (1/2 + 63 (n.v, roughness)) / 64. A texel's x and y are scale and
/// bias of F0 in what a GGX surface with Smith's correlated masking reflects; their sum is the
/// directional albedo E of a surface with F0 = 1. Its z is the directional albedo of Charlie sheen
/// of colour 1 and that roughness, at most 1. It is computed at the first call, in about a tenth of
/// a second.
const Image<Vec3f>& reflectance_table();

/// The values of the table at n.v and roughness, bilinear, clamped.
Vec3d reflectance(double cosine, double roughness);

}  // namespace burl
