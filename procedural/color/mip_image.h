#pragma once
// An image as a texture: a MIP map (Williams 1983) that is looked up between levels, trilinearly or
// by an elliptically weighted average (Heckbert 1989), as in pbrt's image texture (Chuang's slides
// of 2008). Look-ups are in float64 from float texels, with derivatives.
//
// The finest level of an image whose sides are powers of two is its 8-bit codes, decoded at every
// look-up: floats would have the same values and be four times as large, 7 bytes a texel with all
// levels in place of 16, or 12 in place of 32 where the image is transparent.
#include <array>
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
    MipImage(Image<Rgb8> image, ImageWrap wrap);
    /// Makes the levels of an image's colours times alpha, and those of alpha if a texel is
    /// transparent. What resampling overshoots is cut: alpha at 1, colours at alpha.
    MipImage(Image<Rgba8> image, ImageWrap wrap);

    /// The map whose red, green and blue are all the image's alpha; null for an opaque image.
    const MipImage* alpha() const { return alpha_.empty() ? nullptr : &alpha_.front(); }

    ImageWrap wrap() const { return wrap_; }
    std::size_t level_count() const { return levels_.size(); }
    std::size_t width(std::size_t level) const {
        return level > 0 || !has_codes() ? levels_[level].width()
               : codes_.width() > 0      ? codes_.width()
                                         : alphas_.width();
    }
    std::size_t height(std::size_t level) const {
        return level > 0 || !has_codes() ? levels_[level].height()
               : codes_.width() > 0      ? codes_.height()
                                         : alphas_.height();
    }
    /// The texel of a level, 0 <= x < width(level), 0 <= y < height(level).
    RgbF texel(std::size_t level, std::size_t x, std::size_t y) const {
        if (level > 0 || !has_codes()) return levels_[level](x, y);
        if (codes_.width() == 0) {
            const float a = decoded_[alphas_(x, y)];
            return {a, a, a};
        }
        const Rgb8 code = codes_(x, y);
        const RgbF c{decoded_[code.r], decoded_[code.g], decoded_[code.b]};
        if (alpha_.empty()) return c;
        const float a = alpha_.front().texel(0, x, y).r;
        return {a * c.r, a * c.g, a * c.b};
    }

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
    /// The map of an alpha whose sides are powers of two.
    MipImage(Image<std::uint8_t> alphas, ImageWrap wrap);
    bool has_codes() const { return levels_.front().width() == 0; }
    void keep_codes(Image<Rgb8> image);
    void add_levels();
    Vec3d wrapped_texel(std::size_t level, double x, double y) const;
    ImageSample ellipse(std::size_t level, double s, double t, const Vec2d& first,
                        const Vec2d& second) const;

    ImageWrap wrap_;
    Image<Rgb8> codes_{};               ///< level 0 of a colours' map that needs no floats
    Image<std::uint8_t> alphas_{};      ///< level 0 of an alpha's map that needs none
    std::array<float, 256> decoded_{};  ///< linear light of each of the codes, or its alpha
    std::vector<Image<RgbF>> levels_;   ///< the first is empty where there are codes
    std::vector<MipImage> alpha_;       ///< one map of an image that is transparent, else none
};

}  // namespace burl
