#pragma once
// Rectangles of pixels, row 0 first (row 0 is v = 0 in glTF), rows contiguous.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/base/memory.h"

namespace burl {

template <class T>
struct Rgb {
    T r{}, g{}, b{};
    bool operator==(const Rgb&) const = default;
};
using Rgb8 = Rgb<std::uint8_t>;    ///< sRGB-encoded, 0..255
using Rgb16 = Rgb<std::uint16_t>;  ///< sRGB-encoded, 0..65535
using RgbF = Rgb<float>;           ///< linear light

/// A colour with its opacity `a`, 0 (transparent) to the greatest code (opaque), which is linear in
/// all types.
template <class T>
struct Rgba {
    T r{}, g{}, b{}, a{};
    bool operator==(const Rgba&) const = default;
};
using Rgba8 = Rgba<std::uint8_t>;    ///< sRGB-encoded, 0..255, not premultiplied
using Rgba16 = Rgba<std::uint16_t>;  ///< sRGB-encoded, 0..65535, not premultiplied
/// Linear light times opacity (Porter and Duff, "Compositing Digital Images", 1984), so that means
/// of texels are means of what is seen: transparent texels have no colour.
using RgbaF = Rgba<float>;

using Grey8 = std::uint8_t;    ///< a number from 0 to 1, linear, as 0..255
using Grey16 = std::uint16_t;  ///< a number from 0 to 1, linear, as 0..65535

template <class T>
class Image {
  public:
    Image() = default;
    Image(std::size_t width, std::size_t height, T fill = {})
        : width_(width), height_(height), pixels_(width * height, fill) {}
    /// An image whose pixels have no values yet: each must be written before it is read.
    static Image unset(std::size_t width, std::size_t height) {
        Image image;
        image.width_ = width, image.height_ = height;
        image.pixels_ = std::vector<T, PixelAllocator<T>>(width * height);
        return image;
    }

    std::size_t width() const { return width_; }
    std::size_t height() const { return height_; }
    T& operator()(std::size_t x, std::size_t y) { return pixels_[y * width_ + x]; }
    const T& operator()(std::size_t x, std::size_t y) const { return pixels_[y * width_ + x]; }
    std::span<T> row(std::size_t y) { return {pixels_.data() + y * width_, width_}; }
    std::span<const T> row(std::size_t y) const { return {pixels_.data() + y * width_, width_}; }
    std::span<const T> pixels() const { return pixels_; }
    bool operator==(const Image&) const = default;

  private:
    std::size_t width_ = 0, height_ = 0;
    std::vector<T, PixelAllocator<T>> pixels_;
};

/// The image whose pixels are convert(pixel).
template <class To, class From, class Convert>
Image<To> converted(const Image<From>& image, const Convert& convert) {
    auto result = Image<To>::unset(image.width(), image.height());
    for (std::size_t y = 0; y < image.height(); ++y)
        std::ranges::transform(image.row(y), result.row(y).begin(), convert);
    return result;
}

}  // namespace burl
