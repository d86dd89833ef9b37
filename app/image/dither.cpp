#include "app/image/dither.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace burl {

namespace {

using Code = std::array<float, 3>;

Code code_of(const Rgb8& color) {
    return {float(color.r), float(color.g), float(color.b)};
}

/// A palette for look-ups: its channels one after the other, and its colours by their codes.
class DitherPalette {
  public:
    explicit DitherPalette(std::span<const Rgb8> colors) {
        for (const Rgb8& color : colors) {
            exact_.emplace(key(color), std::uint8_t(codes_.size()));
            codes_.push_back(code_of(color));
        }
    }

    const Code& operator[](std::uint8_t index) const { return codes_[index]; }

    std::optional<std::uint8_t> exact(const Rgb8& color) const {
        const auto found = exact_.find(key(color));
        return found == exact_.end() ? std::nullopt : std::optional(found->second);
    }

    std::uint8_t nearest(const Code& wanted) const {
        float least = std::numeric_limits<float>::infinity();
        std::size_t best = 0;
        for (std::size_t i = 0; i < codes_.size(); ++i) {
            float distance = 0.0f;
            for (std::size_t a = 0; a < 3; ++a)
                distance += (codes_[i][a] - wanted[a]) * (codes_[i][a] - wanted[a]);
            if (distance < least) least = distance, best = i;
        }
        return std::uint8_t(best);
    }

  private:
    static std::uint32_t key(const Rgb8& c) {
        return std::uint32_t(c.r) << 16 | std::uint32_t(c.g) << 8 | c.b;
    }
    std::vector<Code> codes_;
    std::map<std::uint32_t, std::uint8_t> exact_;
};

/// The errors that pixels of a row and the one below it are to make up for, with a pixel beyond
/// each end.
struct ErrorRows {
    std::vector<Code> here, below;

    explicit ErrorRows(std::size_t width) : here(width + 2), below(width + 2) {}
    void next_row() {
        here.swap(below);
        std::ranges::fill(below, Code{});
    }
    /// Spreads the error of pixel `x` in a row that goes by `step`, 1 or -1.
    void spread(std::size_t x, int step, const Code& error) {
        const std::size_t i = x + 1, ahead = i + std::size_t(step), behind = i - std::size_t(step);
        for (std::size_t a = 0; a < 3; ++a) {
            here[ahead][a] += error[a] * (7.0f / 16.0f);
            below[behind][a] += error[a] * (3.0f / 16.0f);
            below[i][a] += error[a] * (5.0f / 16.0f);
            below[ahead][a] += error[a] * (1.0f / 16.0f);
        }
    }
};

std::uint8_t dither_pixel(const Rgb8& color, std::size_t x, int step, const DitherPalette& palette,
                          ErrorRows& errors) {
    if (const auto exact = palette.exact(color)) return *exact;
    Code wanted = code_of(color), error{};
    for (std::size_t a = 0; a < 3; ++a)
        wanted[a] = std::clamp(wanted[a] + errors.here[x + 1][a], 0.0f, 255.0f);
    const std::uint8_t chosen = palette.nearest(wanted);
    for (std::size_t a = 0; a < 3; ++a) error[a] = wanted[a] - palette[chosen][a];
    errors.spread(x, step, error);
    return chosen;
}

}  // namespace

Image<std::uint8_t> dithered(const Image<Rgb8>& image, std::span<const Rgb8> colors) {
    const DitherPalette palette(colors);
    auto result = Image<std::uint8_t>::unset(image.width(), image.height());
    ErrorRows errors(image.width());
    for (std::size_t y = 0; y < image.height(); ++y, errors.next_row()) {
        const bool leftwards = y % 2 == 1;
        for (std::size_t i = 0; i < image.width(); ++i) {
            const std::size_t x = leftwards ? image.width() - 1 - i : i;
            result(x, y) = dither_pixel(image(x, y), x, leftwards ? -1 : 1, palette, errors);
        }
    }
    return result;
}

}  // namespace burl
