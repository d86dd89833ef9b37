// GIF through giflib. Every frame has a palette of its own (palette.h), of the colours in the
// rectangle that changes, and is dithered (dither.h). giflib's callback lets no exception out.
#include <exception>
#include <utility>

#include <gif_lib.h>

#include "app/base/atomic_file.h"
#include "app/image/dither.h"
#include "app/image/frame_writer.h"
#include "app/image/palette.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

constexpr int hundredths = 100;           // ticks of a GIF's second
constexpr std::uint8_t half_alpha = 128;  // below it a pixel is transparent
constexpr std::size_t most_gif_side = 65535;

/// The file and the exception that writing to it has thrown.
struct GifTarget {
    AtomicFile file;
    std::exception_ptr thrown{};
};

int on_gif_bytes(::GifFileType* gif, const ::GifByteType* bytes, int count) {
    auto* const target = static_cast<GifTarget*>(gif->UserData);
    try {
        target->file.write(std::span(bytes, std::size_t(count)));
    } catch (...) {
        target->thrown = std::current_exception();
        return 0;
    }
    return count;
}

/// A frame as GIF has it: indices into a palette, of which one may stand for transparent.
struct GifFrame {
    Image<std::uint8_t> pixels;
    std::vector<Rgb8> colors;
    int transparent = NO_TRANSPARENT_COLOR;
};

GifFrame gif_frame(const Image<Rgb8>& image) {
    std::vector<Rgb8> colors = palette_of(image.pixels(), 256);
    Image<std::uint8_t> pixels = dithered(image, colors);
    return {std::move(pixels), std::move(colors)};
}

GifFrame gif_frame(const Image<Rgba8>& image) {
    const auto shown = converted<Rgb8>(image, [](const Rgba8& p) { return Rgb8{p.r, p.g, p.b}; });
    std::vector<Rgb8> opaque;
    for (const Rgba8& p : image.pixels())
        if (p.a >= half_alpha) opaque.push_back({p.r, p.g, p.b});
    if (opaque.empty()) opaque.push_back({});
    GifFrame frame{{}, palette_of(opaque, 255)};
    frame.pixels = dithered(shown, frame.colors);
    frame.transparent = int(frame.colors.size());
    frame.colors.emplace_back();
    for (std::size_t y = 0; y < image.height(); ++y)
        for (std::size_t x = 0; x < image.width(); ++x)
            if (image(x, y).a < half_alpha) frame.pixels(x, y) = std::uint8_t(frame.transparent);
    return frame;
}

struct FreeColors {
    void operator()(::ColorMapObject* map) const { ::GifFreeMapObject(map); }
};
using GifColors = std::unique_ptr<::ColorMapObject, FreeColors>;

/// The colours in giflib's terms, whose number is a power of two.
GifColors gif_colors(const std::vector<Rgb8>& colors) {
    GifColors map(::GifMakeMapObject(1 << ::GifBitSize(int(colors.size())), nullptr));
    if (!map) throw std::bad_alloc();
    for (std::size_t i = 0; i < colors.size(); ++i)
        map->Colors[i] = {colors[i].r, colors[i].g, colors[i].b};
    return map;
}

class GifFrames : public FrameWriter {
  public:
    GifFrames(const std::string& path, const FrameFile& file)
        : target_{AtomicFile(path)}, file_(file) {
        int error = 0;
        gif_ = ::EGifOpen(&target_, on_gif_bytes, &error);
        if (!gif_) throw std::bad_alloc();
        ::EGifSetGifVersion(gif_, true);
    }
    ~GifFrames() override {
        int ignored = 0;
        if (gif_) ::EGifCloseFile(gif_, &ignored);
    }
    GifFrames(const GifFrames&) = delete;
    GifFrames& operator=(const GifFrames&) = delete;

    void add(const Picture& picture) override {
        if (count_ == 0) start(picture);
        // Pixels that become transparent are only cleared as a whole.
        const PixelBox box =
            count_ == 0 || has_alpha(picture) ? whole_box(picture) : changed_box(before_, picture);
        write(std::visit([](const auto& image) { return gif_frame(image); }, cut(picture, box)),
              box);
        before_ = picture;
        ++count_;
    }

    void commit() override {
        int error = 0;
        check(::EGifCloseFile(std::exchange(gif_, nullptr), &error));
        if (target_.thrown) std::rethrow_exception(target_.thrown);
        target_.file.commit();
    }

  private:
    void start(const Picture& first) {
        const auto [width, height] = size_of(first);
        if (width > most_gif_side || height > most_gif_side)
            throw Error(ExitCode::unsupported,
                        fmt::format("{}: a .gif has at most {} pixels a side; write a .png",
                                    target_.file.target(), most_gif_side));
        check(::EGifPutScreenDesc(gif_, int(width), int(height), 8, 0, nullptr));
        if (file_.frames == 1) return;
        const std::uint8_t for_ever[] = {1, 0, 0};
        check(::EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE));
        check(::EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0"));
        check(::EGifPutExtensionBlock(gif_, int(std::size(for_ever)), for_ever));
        check(::EGifPutExtensionTrailer(gif_));
    }

    void write(const GifFrame& frame, const PixelBox& box) {
        const ::GraphicsControlBlock control{
            frame.transparent == NO_TRANSPARENT_COLOR ? DISPOSE_DO_NOT : DISPOSE_BACKGROUND, false,
            file_.frames == 1 ? 0 : frame_ticks(count_, file_.rate, hundredths), frame.transparent};
        ::GifByteType bytes[4];
        ::EGifGCBToExtension(&control, bytes);
        check(::EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, 4, bytes));
        check(::EGifPutImageDesc(gif_, int(box.x), int(box.y), int(box.width), int(box.height),
                                 false, gif_colors(frame.colors).get()));
        std::vector<std::uint8_t> row;  // giflib takes rows that it may change
        for (std::size_t y = 0; y < box.height; ++y) {
            row.assign(frame.pixels.row(y).begin(), frame.pixels.row(y).end());
            check(::EGifPutLine(gif_, row.data(), int(row.size())));
        }
    }

    void check(int done) const {
        if (done == GIF_OK) return;
        if (target_.thrown) std::rethrow_exception(target_.thrown);
        const char* const why = gif_ ? ::GifErrorString(gif_->Error) : nullptr;
        throw Error(ExitCode::runtime, fmt::format("{}: the picture could not be encoded: {}",
                                                   target_.file.target(), why ? why : "memory"));
    }

    GifTarget target_;
    FrameFile file_;
    ::GifFileType* gif_ = nullptr;
    Picture before_;
    int count_ = 0;
};

}  // namespace

std::unique_ptr<FrameWriter> gif_writer(const std::string& path, const FrameFile& file) {
    check_rate(path, file);
    return std::make_unique<GifFrames>(path, file);
}

}  // namespace burl
