#pragma once
// A texture as OpenGL takes it without any conversion, with its MIP levels: made beside the user
// interface, so that showing it is a copy. OpenGL's own levels cost a software renderer more than
// the texture itself.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/base/image.h"

namespace burl {

using Rgba8 = std::array<std::uint8_t, 4>;  ///< sRGB-encoded but for the last, 255

class EditLevels {
  public:
    EditLevels();

    /// `texels` and, where its sides are powers of two, all coarser levels down to one texel: means
    /// in linear light of 2 x 2 codes of the next finer level (of 2 x 1 where one side is a texel
    /// long), rounded to the nearest code, or to the next one but within a fortieth of a code from
    /// the middle between the two. Other textures have level 0 alone.
    std::vector<Image<Rgba8>> operator()(const Image<Rgb8>& texels) const;

  private:
    Image<Rgba8> halved(const Image<Rgba8>& fine) const;
    void halve_row(const Image<Rgba8>& fine, std::size_t y, std::span<Rgba8> row) const;
    std::uint8_t mean(std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d) const {
        return codes_[(linear_[a] + linear_[b] + linear_[c] + linear_[d]) >> shift];
    }

    static constexpr std::uint32_t one = 1U << 20, shift = 6;  // 4 * 2^20 / 2^6 = 2^16
    std::array<std::uint32_t, 256> linear_{};                  ///< light of every code, in 1 / one
    std::vector<std::uint8_t> codes_;  ///< of every sum of four, by its upper bits
};

}  // namespace burl
