#pragma once
// MIP levels (Williams, "Pyramidal Parametrics", 1983) of an image of linear values: every level is
// half as large as the one before and each of its texels the mean of what it covers.
#include <array>
#include <cstddef>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/base/vec.h"

namespace burl {

/// Level 0 is the image itself, level l+1 has max(1, floor(n/2)) texels where level l has n, as in
/// OpenGL and WebGL; the last level is 1 x 1.
template <class T>
struct MipChain {
    std::vector<Image<T>> levels;
};

/// The next level: each texel is the mean over its rectangle of the image. An even side takes two
/// texels each; an odd side of 2m+1 texels becomes m, so every new texel covers 2 + 1/m old ones
/// and takes parts of three (Guthe & Heckbert, "Non-Power-of-Two Mipmap Creation", 2005). The
/// image's mean is kept in both cases. Sums are in double, texels rounded once per level. Not
/// empty. T is float, Vec3f or RgbF.
template <class T>
Image<T> halve(const Image<T>& image);

/// halve(image times factor), both of one size, without an image of the products.
Image<RgbF> halve_product(const Image<RgbF>& image, const Image<float>& factor);

/// The old texels first, first+1, ... of one axis that a new texel covers, weights adding to 1.
struct MipTaps {
    std::size_t first = 0, count = 1;
    std::array<double, 3> weight{1.0, 0.0, 0.0};
};

/// Of all new texels of an axis of `size` old ones: halve's weights are products of two axes'.
std::vector<MipTaps> mip_taps(std::size_t size);

/// All levels of a not empty image of any size, down to 1 x 1.
template <class T>
MipChain<T> build_mip_chain(Image<T> image);

}  // namespace burl
