#include "app/page/data_script.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace burl {

std::string base64(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word = word << 8 | (k < count ? bytes[i + k] : std::uint8_t(0));
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= count ? letters[word >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

void write_data_script(std::string_view file, std::span<const std::uint8_t> bytes,
                       const ByteSink& sink) {
    const auto put = [&](std::string_view text) {
        sink({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    };
    put(fmt::format("burlData(\"{}\",\"", file));
    constexpr std::size_t piece = 3 << 16;  // a multiple of 3, so that only the last is padded
    for (std::size_t at = 0; at < bytes.size(); at += piece)
        put(base64(bytes.subspan(at, std::min(piece, bytes.size() - at))));
    put("\");\n");
}

std::vector<std::uint8_t> rgbe_pixels(std::span<const RgbF> light) {
    std::vector<std::uint8_t> pixels;
    pixels.reserve(4 * light.size());
    for (const RgbF& p : light) {
        int exponent = 0;
        std::frexp(std::max({p.r, p.g, p.b}), &exponent);  // largest < 2^exponent
        if (exponent < -126 || !(std::max({p.r, p.g, p.b}) > 0.0f)) {
            pixels.insert(pixels.end(), 4, 0);
            continue;
        }
        for (const float value : {p.r, p.g, p.b})
            pixels.push_back(std::uint8_t(std::ldexp(std::max(value, 0.0f), 8 - exponent)));
        pixels.push_back(std::uint8_t(exponent + 128));
    }
    return pixels;
}

}  // namespace burl
