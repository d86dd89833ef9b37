// WebP stills through libwebp.
#include <algorithm>
#include <exception>

#include <webp/encode.h>

#include "app/image/picture_coding.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

/// The target of libwebp's bytes: the sink, and what it has thrown.
struct WebpTarget {
    const ByteSink& sink;
    std::exception_ptr thrown{};
    TaskMeter* meter = nullptr;
    std::uint64_t bytes = 0, told = 0;  ///< of the picture's pixels; those that the meter has
};

int on_webp_bytes(const std::uint8_t* data, std::size_t size, const ::WebPPicture* picture) {
    auto* target = static_cast<WebpTarget*>(picture->custom_ptr);
    try {
        target->sink({data, size});
    } catch (...) {
        target->thrown = std::current_exception();
        return 0;
    }
    return 1;
}

/// Tells the meter of the picture's share that is done.
void tell_meter(WebpTarget& target, std::uint64_t percent) {
    const std::uint64_t done = target.bytes * std::min<std::uint64_t>(percent, 100) / 100;
    if (!target.meter || done <= target.told) return;
    target.meter->add(done - target.told);
    target.told = done;
}

int on_webp_progress(int percent, const ::WebPPicture* picture) {
    tell_meter(*static_cast<WebpTarget*>(picture->custom_ptr), std::uint64_t(percent));
    return 1;
}

/// The owner of libwebp's copy of a raster.
struct WebpStill {
    ::WebPPicture raw;

    WebpStill(const CodeRaster& raster, WebpTarget& target, bool lossless) {
        ::WebPPictureInit(&raw);
        raw.width = int(raster.width), raw.height = int(raster.height);
        raw.use_argb = lossless ? 1 : 0;
        raw.writer = on_webp_bytes, raw.custom_ptr = &target;
        raw.progress_hook = on_webp_progress;
    }
    ~WebpStill() { ::WebPPictureFree(&raw); }
    WebpStill(const WebpStill&) = delete;
    WebpStill& operator=(const WebpStill&) = delete;
};

/// The bytes as red, green and blue, which WebP has only.
std::vector<std::uint8_t> rgb_of_grey(const CodeRaster& raster) {
    std::vector<std::uint8_t> rgb;
    rgb.reserve(3 * raster.width * raster.height);
    for (std::size_t i = 0; i < raster.width * raster.height; ++i)
        rgb.insert(rgb.end(), 3, raster.pixels[i]);
    return rgb;
}

bool import_raster(WebpStill& still, const CodeRaster& raster) {
    const int stride = int(raster.width * raster.components);
    if (raster.components == 4)
        return ::WebPPictureImportRGBA(&still.raw, raster.pixels, stride) != 0;
    if (raster.components == 3)
        return ::WebPPictureImportRGB(&still.raw, raster.pixels, stride) != 0;
    return ::WebPPictureImportRGB(&still.raw, rgb_of_grey(raster).data(), 3 * stride) != 0;
}

::WebPConfig still_config(int quality) {
    ::WebPConfig config;
    ::WebPConfigInit(&config);
    if (quality == 100) {
        constexpr int level = 2;  // of 0 to 9 (docs/lab/export.md)
        ::WebPConfigLosslessPreset(&config, level);
        config.exact = 1;
    } else {
        config.quality = float(quality);
    }
    return config;
}

}  // namespace

void encode_webp(const CodeRaster& raster, const ByteSink& sink, int quality, TaskMeter* meter) {
    const ::WebPConfig config = still_config(quality);
    WebpTarget target{sink, {}, meter, raster.stride() * raster.height};
    WebpStill still(raster, target, config.lossless != 0);
    if (import_raster(still, raster) && ::WebPEncode(&config, &still.raw))
        return tell_meter(target, 100);
    if (target.thrown) std::rethrow_exception(target.thrown);
    throw Error(ExitCode::runtime,
                fmt::format("the WebP image of {} x {} could not be encoded: libwebp's error {}",
                            raster.width, raster.height, int(still.raw.error_code)));
}

}  // namespace burl
