#pragma once
// MIP levels (Williams, "Pyramidal Parametrics", 1983) of an image of linear values: every level is
// half as large as the one before, and each of its texels is the mean of the texels it covers.
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/base/vec.h"

namespace burl {

/// All levels of an image. Level 0 is the image itself; level l+1 has max(1, floor(n/2)) texels
/// along a side where level l has n, as in OpenGL and WebGL; the last level is 1 x 1.
template <class T>
struct MipChain {
    std::vector<Image<T>> levels;
};

/// The MIP level after `image`, which must not be empty: each texel is the mean over its rectangle
/// of the image. Along an even side a texel takes two old ones with equal weights; an odd side of
/// 2m+1 texels becomes m, so every new texel covers 2 + 1/m old ones and takes parts of three
/// (Guthe & Heckbert, "Non-Power-of-Two Mipmap Creation", 2005). The image's mean is kept in both
/// cases. Sums are in double, texels rounded once per level. T is float,
/// Vec3f, Vec4f, RgbF or RgbaF.
template <class T>
Image<T> halve(const Image<T>& image);

/// halve() of the texelwise product of `image` and `factor`, which have the same size, without an
/// image of the products. T is float, Vec4f, RgbF or RgbaF.
template <class T>
Image<T> halve_product(const Image<T>& image, const Image<float>& factor);

/// Filter taps of one new texel along one axis: it covers the `count` (1 to 3) old texels from
/// `first` on with these weights, whose sum is 1.
struct MipTaps {
    std::size_t first = 0, count = 1;
    std::array<double, 3> weight{1.0, 0.0, 0.0};
};

/// Filter taps of all max(1, size / 2) new texels of an axis with `size` old ones. The weight that
/// halve() gives an old texel is the product of its column's and its row's.
std::vector<MipTaps> mip_taps(std::size_t size);

/// The MIP level after an image whose rows come in bands, with the bytes of halve() and not more of
/// the image in memory than a band. T is float, Vec4f, RgbF or RgbaF.
template <class T>
class HalvedRows {
  public:
    HalvedRows(std::size_t width, std::size_t height)
        : height_(height), level_(Image<T>::unset(below(width), below(height))) {}

    /// Takes the rows after those that came before.
    void add(const Image<T>& rows);
    /// The level; once, when all rows were added.
    Image<T> take() { return std::move(level_); }

  private:
    static std::size_t below(std::size_t size) { return std::max<std::size_t>(1, size / 2); }

    std::size_t height_;
    Image<T> level_;
    Image<T> carried_{};     ///< rows that the level's next row needs, too
    std::size_t next_ = 0;   ///< row of the level
    std::size_t first_ = 0;  ///< row of the image that comes next, less the carried ones
};

/// All levels of an image of any size but 0, down to 1 x 1.
template <class T>
MipChain<T> build_mip_chain(Image<T> image);

}  // namespace burl
