#pragma once
// MIP levels of a texture in the format that OpenGL takes without conversion. They are made in the
// background, so that an upload is a copy; OpenGL's own MIP levels cost a software renderer more
// than the upload of the texture itself.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/base/image.h"

namespace burl {

/// Makes MIP levels of 8-bit textures by tables. Calls may run at the same time.
class EditLevels {
  public:
    EditLevels();

    /// Returns `texels`, which are sRGB, as level 0 and, where both sides are powers of two, all
    /// coarser levels down to one texel: means in linear light of 2 x 2 texels of the next finer
    /// level (of 2 x 1 where one side is one texel long), rounded to the nearest sRGB code; within
    /// 1/40 of a code from the middle between two codes it may be the other one. Other textures
    /// have level 0 alone. Alpha is 255 everywhere.
    std::vector<Image<Rgba8>> operator()(const Image<Rgb8>& texels) const;
    /// Returns the levels of texels with alpha, whose means are those of the codes; so are those of
    /// red, green and blue unless they are colours.
    std::vector<Image<Rgba8>> operator()(Image<Rgba8> texels, bool is_color) const;

  private:
    Image<Rgba8> halved(const Image<Rgba8>& fine, bool is_color) const;
    void halve_row(const Image<Rgba8>& fine, std::size_t y, bool is_color,
                   std::span<Rgba8> row) const;
    std::uint8_t mean(std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d) const {
        return codes_[(linear_[a] + linear_[b] + linear_[c] + linear_[d]) >> shift];
    }

    static constexpr std::uint32_t one = 1U << 20, shift = 6;  // 4 * 2^20 / 2^6 = 2^16
    /// Linear light of every sRGB code, in units of 1 / one.
    std::array<std::uint32_t, 256> linear_{};
    /// sRGB code of a sum of four lights, indexed by the sum >> shift.
    std::vector<std::uint8_t> codes_;
};

}  // namespace burl
