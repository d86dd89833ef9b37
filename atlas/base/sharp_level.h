#pragma once
// MIP levels that make up for what their lookup blurs. A bilinear lookup in a level of box means
// blurs once more: a wave of f cycles a texel, -1/2 <= f <= 1/2, comes out sinc(f)^2 times as high,
// in the mean over its phases (sinc(f) = sin(pi f) / (pi f)). Weights of -s, 1 + 2 s, -s along x
// and along y raise it by 1 + 2 s (1 - cos(2 pi f)) before; s = 1/12 would take back all of the
// blur of long waves. Filters before an interpolation are those of Thevenaz, Blu & Unser,
// "Interpolation Revisited", 2000.
#include "atlas/base/image.h"
#include "atlas/base/vec.h"

namespace burl {

/// The weight s of a texel's neighbours, chosen by the errors of sampled views
/// (docs/lab/sampled.md): more helps trilinear lookups and takes from anisotropic ones.
inline constexpr double sharpness = 1.0 / 32.0;

/// Sharpens a level of box means in place: texel (x, y) becomes the sum over the 3 x 3 texels round
/// it, those beyond the border being the border's, with the products of -s, 1 + 2 s and -s as
/// weights. A component is at least 0 and at most 1, or what it was where that was more; a colour
/// that is multiplied by its alpha is at most that. Sums are in double and the same for every
/// number of threads. T is float, Vec3f, RgbF or RgbaF (premultiplied).
template <class T>
void sharpen(Image<T>& level);

}  // namespace burl
