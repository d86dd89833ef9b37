#pragma once
// An image as a texture: a MIP map (Williams 1983) that is looked up between levels, trilinearly or
// by an elliptically weighted average (Heckbert 1989), as in pbrt's image texture (Chuang's slides
// of 2008). Look-ups are in float64 from float texels, with derivatives.
//
// Levels are made when a lookup first needs one coarser than the finest, which a texture that is
// not filtered never does. The finest level is the image's 8-bit codes, decoded at every look-up:
// floats would have the same values and be three or four times as large. Only an image that is
// resampled has it as floats besides, up to 2^25 texels; a larger one is resampled at every
// look-up, with the same values. With all levels a texel takes 7 bytes, or 9 where the image is
// transparent, and 16 or 21 besides the codes where it is kept as floats.
#include <algorithm>
#include <bit>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/base/vec.h"
#include "procedural/color/image_rows.h"

namespace burl {

/// Linear light, multiplied by alpha, and its derivatives by s and t. An image spans [0, 1]^2, row
/// 0 from t = 0 on.
struct ImageSample {
    Vec3d color{0.0}, by_s{0.0}, by_t{0.0};
};

/// Number of texels up to which the finest level of a resampled image is kept as floats.
inline constexpr std::size_t most_kept_texels = std::size_t{1} << 25;

/// The MIP map of an image, or of its alpha.
class MipImage {
  public:
    /// Takes an image, which must not be empty. A resampled finest level of at most `most_kept`
    /// texels is kept as floats. Every further level is the mean of 2 x 2 texels of the one before.
    MipImage(Image<Rgb8> image, ImageWrap wrap, std::size_t most_kept = most_kept_texels);
    /// Takes an image whose colours count times alpha, and its alpha if a texel is transparent.
    MipImage(Image<Rgba8> image, ImageWrap wrap, std::size_t most_kept = most_kept_texels);

    /// The map whose red, green and blue are all the image's alpha; null for an opaque image.
    const MipImage* alpha() const { return alpha_.get(); }

    ImageWrap wrap() const { return wrap_; }
    std::size_t level_count() const { return std::bit_width(std::max(width(0), height(0))); }
    std::size_t width(std::size_t level) const {
        return std::max<std::size_t>(codes_->width() >> level, 1);
    }
    std::size_t height(std::size_t level) const {
        return std::max<std::size_t>(codes_->height() >> level, 1);
    }
    /// The texel of a level, 0 <= x < width(level), 0 <= y < height(level).
    RgbF texel(std::size_t level, std::size_t x, std::size_t y) const {
        return texel_of(level_texels(level), x, y);
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

    /// Whether the two are maps of the same image in the same wrap.
    bool operator==(const MipImage& other) const {
        return wrap_ == other.wrap_ && of_alpha_ == other.of_alpha_ && *codes_ == *other.codes_;
    }

  private:
    /// The texels of a level: colours, or alphas, or none where they come from the codes.
    struct Texels {
        Image<RgbF> colors{};
        Image<float> alphas{};
    };
    /// The levels from the second on, made once, by the thread that needs them first.
    struct Coarser {
        std::once_flag made;
        std::vector<Texels> levels;
    };
    /// A level that is looked up.
    struct Level {
        const Texels& texels;
        std::size_t width, height;
    };

    MipImage(std::shared_ptr<const ImageCodes> codes, ImageWrap wrap, std::size_t most_kept,
             bool of_alpha);
    void make_coarser() const;
    const Texels& level_texels(std::size_t level) const;
    Level level_of(std::size_t level) const {
        return {level_texels(level), width(level), height(level)};
    }
    RgbF texel_of(const Texels& texels, std::size_t x, std::size_t y) const {
        if (texels.colors.width() > 0) return texels.colors(x, y);
        if (texels.alphas.width() == 0 && !of_alpha_) return codes_->texel<RgbF>(x, y);
        const float a =
            texels.alphas.width() > 0 ? texels.alphas(x, y) : codes_->texel<float>(x, y);
        return {a, a, a};
    }
    Vec3d wrapped_texel(const Level& level, double x, double y) const;
    ImageSample ellipse(std::size_t level, double s, double t, const Vec2d& first,
                        const Vec2d& second) const;

    std::shared_ptr<const ImageCodes> codes_;
    ImageWrap wrap_;
    bool of_alpha_ = false;
    Texels finest_{};
    std::unique_ptr<Coarser> coarser_ = std::make_unique<Coarser>();
    std::unique_ptr<const MipImage> alpha_{};
};

}  // namespace burl
