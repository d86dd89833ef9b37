#include "app/bake/material_bands.h"

#include <algorithm>
#include <utility>

#include "atlas/base/mip_chain.h"
#include "atlas/base/sharp_level.h"
#include "atlas/build/block_levels.h"

namespace burl {

namespace {

constexpr std::size_t least_rows = 64, band_pixels = std::size_t(1) << 21;

/// The component `c` of a pixel.
float& component(float& pixel, std::size_t) {
    return pixel;
}
float& component(RgbF& pixel, std::size_t c) {
    return c == 0 ? pixel.r : c == 1 ? pixel.g : pixel.b;
}
float& component(RgbaF& pixel, std::size_t c) {
    return c == 0 ? pixel.r : c == 1 ? pixel.g : c == 2 ? pixel.b : pixel.a;
}

template <class Code>
PictureImage codes_of_picture(const Image<float>& picture, bool) {
    if constexpr (sizeof(Code) == 1) return to_grey8(picture);
    return to_grey16(picture);
}

template <class Code>
PictureImage codes_of_picture(const Image<RgbF>& picture, bool is_color) {
    if constexpr (sizeof(Code) == 1) return is_color ? to_rgb8(picture) : to_linear8(picture);
    return is_color ? to_rgb16(picture) : to_linear16(picture);
}

template <class Code>
PictureImage codes_of_picture(const Image<RgbaF>& picture, bool is_color) {
    if constexpr (sizeof(Code) == 1)
        return is_color ? to_rgba8(picture, mean_color(picture)) : to_linear8(picture);
    return is_color ? to_rgba16(picture, mean_color(picture)) : to_linear16(picture);
}

}  // namespace

std::size_t rows_of_bands(std::size_t size, std::size_t pictures) {
    return least_rows *
           std::max<std::size_t>(1, band_pixels / (least_rows * (size + 1) * (pictures + 1)));
}

FloatPicture float_picture(const Image<RgbaF>& rows, std::size_t components) {
    if (components == 4) return rows;
    if (components == 1) return component_of(rows, 0);
    return converted<RgbF>(rows, [](const RgbaF& p) { return RgbF{p.r, p.g, p.b}; });
}

Image<float> component_of(const Image<RgbaF>& rows, std::size_t c) {
    return converted<float>(rows, [c](RgbaF p) { return component(p, c); });
}

template <class Code>
PictureImage picture_codes(const FloatPicture& picture, bool is_color) {
    return std::visit([&](const auto& image) { return codes_of_picture<Code>(image, is_color); },
                      picture);
}

template <class Pixel>
RowsOfLevels<Pixel>::RowsOfLevels(const MeshAtlas& atlas) : size_(atlas.atlas().options.size) {
    if (halves_in_bands(atlas)) halved_.emplace(size_, size_);
}

template <class Pixel>
void RowsOfLevels<Pixel>::add(std::size_t first, const Image<Pixel>& rows) {
    if (halved_)
        halved_->add(rows);
    else
        put_rows(rows, first, size_, whole_);
}

template <class Pixel>
std::vector<Image<Pixel>> RowsOfLevels<Pixel>::levels(const MeshAtlas& atlas, std::uint32_t count) {
    Image<Pixel> finest = halved_ ? halved_->take() : std::move(whole_);
    std::vector<Image<Pixel>> levels = block_levels(atlas, finest, count, halved_ ? 1 : 0);
    if (halved_) levels.insert(levels.begin(), std::move(finest));
    return levels;
}

template class RowsOfLevels<Vec4f>;

void LevelRows::add(std::size_t first, const FloatPicture& rows) {
    std::visit(
        [&]<class Pixel>(const Image<Pixel>& band) {
            using Rows = RowsOfLevels<Pixel>;
            if (first == 0) rows_ = Rows(*atlas_);
            std::get<Rows>(rows_).add(first, band);
        },
        rows);
}

std::vector<FloatPicture> LevelRows::levels() {
    std::vector<FloatPicture> all;
    std::visit(
        [&]<class Rows>(Rows& rows) {
            if constexpr (!std::is_same_v<Rows, std::monostate>)
                for (auto& level : rows.levels(*atlas_, count_)) {
                    if (sharp_) burl::sharpen(level);
                    all.emplace_back(std::move(level));
                }
        },
        rows_);
    return all;
}

std::vector<NormalLevel> NormalRows::levels() {
    std::vector<NormalLevel> all;
    for (const Image<Vec4f>& level : rows_.levels(*atlas_, count_))
        all.push_back(normal_level(level));
    return all;
}

void set_roughness(std::vector<FloatPicture>& levels, const std::vector<NormalLevel>& normals,
                   std::size_t c, float sign, float offset) {
    const auto set = [&](auto& level, const Image<float>& roughness) {
        for (std::size_t y = 0; y < roughness.height(); ++y)
            for (std::size_t x = 0; x < roughness.width(); ++x)
                component(level(x, y), c) = offset + sign * roughness(x, y);
    };
    for (std::size_t l = 0; l < levels.size() && l < normals.size(); ++l)
        std::visit([&](auto& level) { set(level, normals[l].roughness); }, levels[l]);
}

void ClearTexels::add(std::size_t first, const Image<RgbaF>& rows) {
    mean_.add(rows);
    for (std::size_t i = 0; i < rows.pixels().size(); ++i)
        if (!(rows.pixels()[i].a > 0.0f)) clear_[first * rows.width() + i] = true;
}

template <class Code>
void ClearTexels::fill(Image<Rgba<Code>>& codes) const {
    const Image<RgbaF> nothing(1, 1);
    Rgba<Code> code;
    if constexpr (sizeof(Code) == 1)
        code = to_rgba8(nothing, mean_.mean())(0, 0);
    else
        code = to_rgba16(nothing, mean_.mean())(0, 0);
    for (std::size_t i = 0; i < clear_.size(); ++i)
        if (clear_[i]) codes(i % codes.width(), i / codes.width()) = code;
}

template PictureImage picture_codes<std::uint8_t>(const FloatPicture&, bool);
template PictureImage picture_codes<std::uint16_t>(const FloatPicture&, bool);
template void ClearTexels::fill(Image<Rgba8>&) const;
template void ClearTexels::fill(Image<Rgba16>&) const;

}  // namespace burl
