#pragma once
// An image as the finest level of a MIP map: rows and texels in linear light, times alpha, with
// sides that are powers of two. A side that is none is resampled to the next one with Lanczos's
// filter of four points, as pbrt does (image textures; Duchon, "Lanczos Filtering in One and Two
// Dimensions", 1979), along rows first; what falls below 0 is cut, and what overshoots alpha, too.
//
// Rows are for whoever needs all texels, since rows that were filtered along are kept for the next
// ones; a single texel takes sixteen of the image.
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "atlas/base/image.h"

namespace burl {

/// The colours outside [0, 1]^2; `black` is transparent there if the image is somewhere.
enum class ImageWrap { repeat, black, clamp };

/// The index of texel x within [0, size), or -1 where the wrap gives black.
std::ptrdiff_t wrapped_index(double x, std::size_t size, ImageWrap wrap);

/// The four texels of a side from which a texel of the resampled side is made (-1: black), and
/// their weights, which add up to one.
struct LanczosTaps {
    std::array<std::ptrdiff_t, 4> index{};
    std::array<double, 4> weight{};
    bool operator==(const LanczosTaps&) const = default;
};

/// The codes of an image, whose colours are in linear light times alpha.
class ImageCodes {
  public:
    ImageCodes(Image<Rgb8> image, ImageWrap wrap);
    /// An image without transparent texels is kept without its alpha.
    ImageCodes(Image<Rgba8> image, ImageWrap wrap);

    /// Sides of the finest level: the image's own, up to the next powers of two.
    std::size_t width() const { return width_; }
    std::size_t height() const { return height_; }
    bool is_resampled() const { return !columns_.empty() || !rows_.empty(); }
    bool is_opaque() const { return transparent_.width() == 0; }

    /// A texel of the finest level, 0 <= x < width(), 0 <= y < height(): its colour where Texel is
    /// RgbF, its alpha where Texel is float.
    template <class Texel>
    Texel texel(std::size_t x, std::size_t y) const {
        return is_resampled() ? resampled<Texel>(x, y) : decoded<Texel>(x, y);
    }

    bool operator==(const ImageCodes&) const = default;

  private:
    template <class Texel>
    friend class ImageRows;
    template <class Texel>
    Texel decoded(const Rgb8& code) const;
    template <class Texel>
    Texel decoded(const Rgba8& code) const;
    template <class Texel>
    Texel decoded(std::size_t x, std::size_t y) const;
    template <class Texel>
    Texel resampled(std::size_t x, std::size_t y) const;
    void set_sides(std::size_t columns, std::size_t rows, ImageWrap wrap);

    Image<Rgb8> opaque_{};             ///< the codes of an image without transparent texels
    Image<Rgba8> transparent_{};       ///< those of another
    std::array<float, 256> linear_{};  ///< linear light of each code of sRGB
    std::size_t width_ = 0, height_ = 0;
    std::vector<LanczosTaps> columns_{}, rows_{};  ///< none where the side is a power of two
};

/// The rows of the finest level, which are best asked for in order: five rows that were filtered
/// along are kept, one more than a column's taps need.
template <class Texel>
class ImageRows {
  public:
    explicit ImageRows(const ImageCodes& codes);
    /// Row y, which stays until the next one is asked for.
    const std::vector<Texel>& operator()(std::size_t y);

  private:
    struct Row {
        std::ptrdiff_t y = -1;
        std::vector<Texel> texels{};
    };
    const std::vector<Texel>& wide_row(std::size_t y);
    void fill(Row& row, std::size_t y);

    const ImageCodes& codes_;
    std::vector<Texel> decoded_, row_;
    const std::vector<Texel> black_;
    std::array<Row, 5> wide_;                   ///< the one asked for last at the end
    std::unique_ptr<ImageRows<float>> limits_;  ///< alphas of colours that may overshoot them
};

}  // namespace burl
