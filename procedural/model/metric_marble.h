#pragma once
// The texture that atlases are measured with: marble of Perlin's improved noise with his published
// permutation ("Improving Noise", 2002), so that other programs can measure the same. One linear
// channel, no filter, no rounding.
#include "atlas/base/vec.h"

namespace burl {

/// (1 - cos 2 pi f) / 2, f = 2 p_z + sum_{i=0..3} 2^-i perlin(2^(i+1) p), p = s + (.013,.027,.041).
/// `s` is relative to the middle of the mesh's box, in half diagonals of the box.
double metric_marble(const Vec3d& s);

}  // namespace burl
