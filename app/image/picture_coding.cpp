#include "app/image/picture_coding.h"

#include <algorithm>
#include <charconv>

#include <fmt/ranges.h>
#include <webp/encode.h>

#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"

namespace burl {
namespace {

struct FormatNames {
    std::string_view word, extension, media_type;
    int least, most;  ///< qualities; none where both are 0
    std::size_t most_pixels;
};

/// In the order of TextureFormat. The sides are those that the libraries write.
constexpr std::array<FormatNames, 4> format_names{{
    {"png", ".png", "image/png", 0, 0, 1u << 20},
    {"jpeg", ".jpg", "image/jpeg", 1, 100, 65500},
    {"webp", ".webp", "image/webp", 0, 100, WEBP_MAX_DIMENSION},
    {"ktx2", ".ktx2", "image/ktx2", 0, 19, 1u << 20},
}};

const FormatNames& names_of(TextureFormat format) {
    return format_names[std::size_t(format)];
}

template <class Pixel>
constexpr bool has_eight_bits = false;
template <>
constexpr bool has_eight_bits<Rgb8> = true;
template <>
constexpr bool has_eight_bits<Rgba8> = true;
template <>
constexpr bool has_eight_bits<Grey8> = true;

Error not_in(TextureFormat format, std::string_view what) {
    return Error(ExitCode::unsupported,
                 fmt::format("a {} has no {}; write a .png", extension_of(format), what));
}

void encode_codes(const CodeRaster& raster, const ByteSink& sink, const PictureCoding& coding,
                  PngContent content) {
    const bool data = content == PngContent::data;
    if (coding.format == TextureFormat::ktx2)
        return encode_ktx2({&raster, 1}, sink, coding.quality.value_or(ktx2_level), content,
                           coding.meter);
    if (coding.format == TextureFormat::webp)
        return encode_webp(raster, sink, data ? 100 : coding.quality.value_or(100), coding.meter);
    if (raster.components == 4) throw not_in(coding.format, "alpha");
    const int quality = coding.quality.value_or(jpeg_quality);
    encode_jpeg(raster, sink, data ? std::max(quality, jpeg_data_quality) : quality, coding.meter);
}

}  // namespace

PictureCoding coding_named(const std::string& text) {
    const std::size_t colon = text.find(':');
    const auto wrong = [&](const std::string& why) {
        return Error(ExitCode::usage, fmt::format("--picture-format {}: {}", text, why));
    };
    const auto* names = std::ranges::find(format_names, text.substr(0, colon), &FormatNames::word);
    if (names == format_names.end())
        throw wrong("must be png, jpeg, webp or ktx2, with or without a quality, as in jpeg:90");
    PictureCoding coding{TextureFormat(names - format_names.begin()), {}};
    if (colon == std::string::npos) return coding;
    if (names->most == 0) throw wrong("a .png keeps every code and has no quality");
    int quality = 0;
    const char *begin = text.data() + colon + 1, *end = text.data() + text.size();
    const auto [stop, failure] = std::from_chars(begin, end, quality);
    if (failure != std::errc() || stop != end || quality < names->least || quality > names->most)
        throw wrong(fmt::format("what follows {}: must be a number from {} to {}", names->word,
                                names->least, names->most));
    coding.quality = quality;
    return coding;
}

std::string_view to_string(TextureFormat format) {
    return names_of(format).word;
}

std::string_view extension_of(TextureFormat format) {
    return names_of(format).extension;
}

std::string_view media_type(TextureFormat format) {
    return names_of(format).media_type;
}

std::size_t most_pixels(TextureFormat format) {
    return names_of(format).most_pixels;
}

std::optional<TextureFormat> texture_format_of(const std::string& path) {
    const std::string extension = lower_extension(path);
    if (extension == ".jpeg") return TextureFormat::jpeg;
    const auto* names = std::ranges::find(format_names, extension, &FormatNames::extension);
    if (names == format_names.end()) return std::nullopt;
    return TextureFormat(names - format_names.begin());
}

template <class Pixel>
void encode_picture(const Image<Pixel>& image, const ByteSink& sink, const PictureCoding& coding,
                    PngContent content) {
    const TextureFormat format = coding.format;
    if (format == TextureFormat::png) return encode_png(image, sink, content, coding.meter);
    if (std::max(image.width(), image.height()) > most_pixels(format))
        throw Error(
            ExitCode::unsupported,
            fmt::format("a {} has at most {} pixels a side, and this picture has {} x {}; "
                        "write a .png",
                        extension_of(format), most_pixels(format), image.width(), image.height()));
    if constexpr (has_eight_bits<Pixel>)
        encode_codes(codes_of(image), sink, coding, content);
    else
        throw not_in(format, "16 bits");
}

template void encode_picture(const Image<Rgb8>&, const ByteSink&, const PictureCoding&, PngContent);
template void encode_picture(const Image<Rgb16>&, const ByteSink&, const PictureCoding&,
                             PngContent);
template void encode_picture(const Image<Rgba8>&, const ByteSink&, const PictureCoding&,
                             PngContent);
template void encode_picture(const Image<Rgba16>&, const ByteSink&, const PictureCoding&,
                             PngContent);
template void encode_picture(const Image<Grey8>&, const ByteSink&, const PictureCoding&,
                             PngContent);
template void encode_picture(const Image<Grey16>&, const ByteSink&, const PictureCoding&,
                             PngContent);

}  // namespace burl
