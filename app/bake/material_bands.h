#pragma once
// A material's pictures as they come in bands of rows: what of them stays in memory are their codes
// and, for MIP levels, level 1 in floats, a quarter of the texels; not all pictures in floats.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "app/export/export.h"
#include "app/image/convert_image.h"
#include "atlas/base/image.h"
#include "atlas/base/mip_chain.h"
#include "atlas/build/mesh_atlas.h"
#include "atlas/build/normal_levels.h"

namespace burl {

/// An image in linear floats of as many components as its picture has: 1, 3 or 4.
using FloatPicture = std::variant<Image<float>, Image<RgbF>, Image<RgbaF>>;

/// The number of rows of a band of so many pictures of `size` texels a side: a multiple of 64 and
/// so of all that works on several rows at a time, with two million pixels or 64 rows.
std::size_t rows_of_bands(std::size_t size, std::size_t pictures);

/// The first 1, 3 or 4 components of the pixels.
FloatPicture float_picture(const Image<RgbaF>& rows, std::size_t components);
/// The number c of the pixels' components.
Image<float> component_of(const Image<RgbaF>& rows, std::size_t c);

/// The codes of linear floats, sRGB if they are colours; colours are premultiplied where there are
/// four components. Code is std::uint8_t or std::uint16_t.
template <class Code>
PictureImage picture_codes(const FloatPicture& picture, bool is_color);

/// Copies the rows into the image from row `first` on, which the first rows make as large as
/// `size` x `size`; takes them where they are all of it.
template <class Pixel>
void put_rows(Image<Pixel> rows, std::size_t first, std::size_t size, Image<Pixel>& image) {
    if (rows.height() == size) {
        image = std::move(rows);
        return;
    }
    if (first == 0) image = Image<Pixel>::unset(size, size);
    std::ranges::copy(rows.pixels(), &image(0, first));
}
/// put_rows() for an image of one of several kinds of pixels, which the first rows decide.
template <class... Images>
void put_rows(std::variant<Images...> rows, std::size_t first, std::size_t size,
              std::variant<Images...>& image) {
    std::visit(
        [&]<class Rows>(Rows& from) {
            if (first == 0) image = Rows();
            put_rows(std::move(from), first, size, std::get<Rows>(image));
        },
        rows);
}

/// The rows of which MIP levels are made, as they come in bands: level 1, or level 0 where that is
/// not made of rows alone (halves_in_bands).
template <class Pixel>
class RowsOfLevels {
  public:
    explicit RowsOfLevels(const MeshAtlas& atlas);
    void add(std::size_t first, const Image<Pixel>& rows);
    /// Levels 1 to `count`; once, when all rows were added.
    std::vector<Image<Pixel>> levels(const MeshAtlas& atlas, std::uint32_t count);

  private:
    std::optional<HalvedRows<Pixel>> halved_{};
    std::size_t size_;
    Image<Pixel> whole_{};
};

/// The MIP levels of a picture whose rows come in bands.
class LevelRows {
  public:
    /// `count` is the number of levels above level 0. The atlas must outlive the object.
    LevelRows(const MeshAtlas& atlas, std::uint32_t count) : atlas_(&atlas), count_(count) {}

    void add(std::size_t first, const FloatPicture& rows);
    /// Makes the levels sharp ones (atlas/base/sharp_level.h).
    void sharpen() { sharp_ = true; }
    /// Levels 1 to the last; once, when all rows were added.
    std::vector<FloatPicture> levels();

  private:
    const MeshAtlas* atlas_;
    std::uint32_t count_;
    bool sharp_ = false;
    std::variant<std::monostate, RowsOfLevels<float>, RowsOfLevels<RgbF>, RowsOfLevels<RgbaF>>
        rows_{};
};

/// The MIP levels of a normal map with its roughness, which come in bands.
class NormalRows {
  public:
    NormalRows(const MeshAtlas& atlas, std::uint32_t count)
        : atlas_(&atlas), count_(count), rows_(atlas) {}

    void add(std::size_t first, const Image<RgbF>& normals, const Image<float>& roughness) {
        rows_.add(first, normal_moments(normals, roughness));
    }
    std::vector<NormalLevel> levels();

  private:
    const MeshAtlas* atlas_;
    std::uint32_t count_;
    RowsOfLevels<Vec4f> rows_;
};

/// Gives the levels of a picture the roughness of the normals' levels in component c, where the
/// picture holds offset + sign * roughness.
void set_roughness(std::vector<FloatPicture>& levels, const std::vector<NormalLevel>& normals,
                   std::size_t c, float sign, float offset);

/// The texels of a transparent colour that have none, and the colour that they get: the mean, which
/// is known when all rows have come.
class ClearTexels {
  public:
    /// The plan of a texture of `size` x `size` texels.
    explicit ClearTexels(std::size_t size) : clear_(size * size) {}

    void add(std::size_t first, const Image<RgbaF>& rows);
    /// Gives them their colour in the codes of level 0.
    template <class Code>
    void fill(Image<Rgba<Code>>& codes) const;

  private:
    std::vector<bool> clear_;
    ColorMean mean_{};
};

}  // namespace burl
