#pragma once
// An image as a texture: a MIP map (Williams 1983) that is looked up between levels, trilinearly or
// by an elliptically weighted average (Heckbert 1989), as in pbrt's image texture (Chuang's slides
// of 2008). Look-ups are in float64 from float texels, with derivatives.
#include <vector>

#include "atlas/base/image.h"
#include "atlas/base/vec.h"

namespace burl {

/// The colours outside [0, 1]^2; `black` is transparent there if the image is somewhere.
enum class ImageWrap { repeat, black, clamp };

/// Linear light, multiplied by alpha, and its derivatives by s and t. An image spans [0, 1]^2, row
/// 0 from t = 0 on.
struct ImageSample {
    Vec3d color{0.0}, by_s{0.0}, by_t{0.0};
};

/// The MIP map of an image.
class MipImage {
  public:
    /// Makes the levels of an image, which must not be empty. A side that is no power of two is
    /// resampled to the next one with Lanczos's filter (4 points, never below 0); every further
    /// level is the mean of 2 x 2 texels.
    MipImage(const Image<Rgb8>& image, ImageWrap wrap);
    /// Makes the levels of an image's colours times alpha, and those of alpha if a texel is
    /// transparent. What resampling overshoots is cut: alpha at 1, colours at alpha.
    MipImage(const Image<Rgba8>& image, ImageWrap wrap);

    /// The map whose red, green and blue are all the image's alpha; null for an opaque image.
    const MipImage* alpha() const { return alpha_.empty() ? nullptr : &alpha_.front(); }

    ImageWrap wrap() const { return wrap_; }
    const std::vector<Image<RgbF>>& levels() const { return levels_; }

    /// Bilinear interpolation within a level.
    ImageSample bilinear(std::size_t level, double s, double t) const;

    /// Linear interpolation between the two levels whose texels are nearest to `width`, a length in
    /// s and t: pbrt's level is level count - 1 + log2(width). Width 0 is bilinear in level 0.
    ImageSample trilinear(double s, double t, double width) const;

    /// The mean under a Gaussian exp(-2 r^2) - exp(-2) over the ellipse with the footprint's two
    /// steps `first` and `second`; the ellipse is widened where they are more than `anisotropy`
    /// times unequal, so that its texels stay few.
    ImageSample ewa(double s, double t, Vec2d first, Vec2d second, double anisotropy) const;

    bool operator==(const MipImage&) const = default;

  private:
    MipImage(Image<RgbF> finest, ImageWrap wrap);
    Vec3d texel(std::size_t level, double x, double y) const;
    ImageSample ellipse(std::size_t level, double s, double t, const Vec2d& first,
                        const Vec2d& second) const;

    ImageWrap wrap_;
    std::vector<Image<RgbF>> levels_;
    std::vector<MipImage> alpha_;  ///< one map of an image that is transparent, else none
};

}  // namespace burl
