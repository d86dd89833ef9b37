// WebP through libwebp: stills, and animations by its own encoder, which stores what changes from
// frame to frame.
#include <memory>

#include <malloc.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include "app/base/atomic_file.h"
#include "app/image/frame_writer.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

/// The owner of libwebp's copy of a picture.
struct WebpPicture {
    ::WebPPicture raw;

    explicit WebpPicture(const Picture& picture) {
        ::WebPPictureInit(&raw);
        const auto [width, height] = size_of(picture);
        raw.use_argb = 1, raw.width = int(width), raw.height = int(height);
        const auto* const rgba = std::get_if<Image<Rgba8>>(&picture);
        const int stride = int(width) * (rgba ? 4 : 3);
        const int taken =
            rgba ? ::WebPPictureImportRGBA(&raw, &rgba->pixels().data()->r, stride)
                 : ::WebPPictureImportRGB(&raw, &std::get<Image<Rgb8>>(picture).pixels().data()->r,
                                          stride);
        if (!taken) throw Error(ExitCode::runtime, "a .webp picture could not be encoded: memory");
    }
    ~WebpPicture() { ::WebPPictureFree(&raw); }
    WebpPicture(const WebpPicture&) = delete;
    WebpPicture& operator=(const WebpPicture&) = delete;
};

::WebPConfig webp_config(int quality) {
    ::WebPConfig config;
    ::WebPConfigInit(&config);
    if (quality >= lossless_quality) {
        config.lossless = 1, config.exact = 1;
    } else {
        config.quality = float(quality);
        config.use_sharp_yuv = 1;  // borders of saturated colours stay sharp
    }
    return config;
}

class WebpFrames : public FrameWriter {
  public:
    WebpFrames(const std::string& path, const FrameFile& file)
        : out_(path), file_(file), config_(webp_config(file.quality)) {}

    void add(const Picture& picture) override {
        if (!encoder_) start(picture);
        WebpPicture copy(picture);
        const int added = ::WebPAnimEncoderAdd(encoder_.get(), &copy.raw, milliseconds_, &config_);
        check(added);
        // Among the megabytes that libwebp takes and gives back for a frame it keeps some
        // kilobytes, and the C library's heap would grow by those megabytes.
        ::malloc_trim(0);
        milliseconds_ += frame_ticks(count_++, file_.rate, 1000);
    }

    void commit() override {
        check(::WebPAnimEncoderAdd(encoder_.get(), nullptr, milliseconds_, nullptr));
        ::WebPData data;
        ::WebPDataInit(&data);
        const int assembled = ::WebPAnimEncoderAssemble(encoder_.get(), &data);
        const std::unique_ptr<::WebPData, Clear> encoded(&data);
        check(assembled);
        out_.write({data.bytes, data.size});
        out_.commit();
    }

  private:
    struct Clear {
        void operator()(::WebPData* data) const { ::WebPDataClear(data); }
    };
    struct Delete {
        void operator()(::WebPAnimEncoder* encoder) const { ::WebPAnimEncoderDelete(encoder); }
    };

    void start(const Picture& first) {
        const auto [width, height] = size_of(first);
        if (width > WEBP_MAX_DIMENSION || height > WEBP_MAX_DIMENSION)
            throw Error(ExitCode::unsupported,
                        fmt::format("{}: a .webp has at most {} pixels a side, and this picture "
                                    "has {} x {}; write a .png",
                                    out_.target(), WEBP_MAX_DIMENSION, width, height));
        ::WebPAnimEncoderOptions options;
        ::WebPAnimEncoderOptionsInit(&options);
        encoder_.reset(::WebPAnimEncoderNew(int(width), int(height), &options));
        check(encoder_ != nullptr);
    }
    void check(int done) const {
        if (done) return;
        const char* const why = encoder_ ? ::WebPAnimEncoderGetError(encoder_.get()) : "memory";
        throw Error(ExitCode::runtime,
                    fmt::format("{}: the picture could not be encoded: {}", out_.target(), why));
    }

    AtomicFile out_;
    FrameFile file_;
    ::WebPConfig config_;
    std::unique_ptr<::WebPAnimEncoder, Delete> encoder_;
    int count_ = 0, milliseconds_ = 0;
};

}  // namespace

std::unique_ptr<FrameWriter> webp_writer(const std::string& path, const FrameFile& file) {
    return std::make_unique<WebpFrames>(path, file);
}

}  // namespace burl
