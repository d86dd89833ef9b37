#include "app/image/frame_writer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/base/atomic_file.h"
#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"

namespace burl {

namespace {

constexpr double most_gif_rate = 50.0;

class PngFrames : public FrameWriter {
  public:
    explicit PngFrames(std::vector<std::string> paths) : paths_(std::move(paths)) {}

    void add(const Picture& picture) override {
        AtomicFile file(paths_.at(next_++));
        std::visit([&](const auto& image) { encode_png(image, sink_of(file)); }, picture);
        file.commit();
    }
    void commit() override {}

  private:
    std::vector<std::string> paths_;
    std::size_t next_ = 0;
};

template <class Pixel>
bool row_differs(const Image<Pixel>& a, const Image<Pixel>& b, std::size_t y) {
    return !std::ranges::equal(a.row(y), b.row(y));
}

template <class Pixel>
bool column_differs(const Image<Pixel>& a, const Image<Pixel>& b, std::size_t x) {
    for (std::size_t y = 0; y < a.height(); ++y)
        if (a(x, y) != b(x, y)) return true;
    return false;
}

/// The first and the last + 1 of `count` numbers for which differs(i) holds; 0 and 1 for none.
template <class Differs>
std::pair<std::size_t, std::size_t> changed_range(std::size_t count, const Differs& differs) {
    std::size_t first = 0, last = count;
    while (first < count && !differs(first)) ++first;
    if (first == count) return {0, 1};
    while (!differs(last - 1)) --last;
    return {first, last};
}

}  // namespace

PictureFormat picture_format(const std::string& path) {
    const std::string extension = lower_extension(path);
    if (extension == ".png") return PictureFormat::png;
    if (extension == ".apng") return PictureFormat::apng;
    if (extension == ".webp") return PictureFormat::webp;
    if (extension == ".gif") return PictureFormat::gif;
    throw Error(
        ExitCode::usage,
        fmt::format("{}: the name of a picture must end in .png, .webp, .gif or .apng", path));
}

void check_rate(const std::string& path, const FrameFile& file) {
    if (picture_format(path) == PictureFormat::gif && file.frames > 1 && file.rate > most_gif_rate)
        throw Error(ExitCode::usage,
                    fmt::format("{}: viewers slow down a .gif of more than {} frames a second; "
                                "make --fps less, or write a .webp",
                                path, most_gif_rate));
}

std::unique_ptr<FrameWriter> png_writer(std::vector<std::string> paths) {
    return std::make_unique<PngFrames>(std::move(paths));
}

std::unique_ptr<FrameWriter> frame_writer(const std::vector<std::string>& paths,
                                          const FrameFile& file) {
    switch (picture_format(paths.front())) {
        case PictureFormat::apng:
            return apng_writer(paths.front(), file);
        case PictureFormat::webp:
            return webp_writer(paths.front(), file);
        case PictureFormat::gif:
            return gif_writer(paths.front(), file);
        case PictureFormat::png:
            break;
    }
    return png_writer(paths);
}

int frame_ticks(int i, double rate, int ticks_per_second) {
    const auto begin = [&](int frame) { return std::lround(frame * ticks_per_second / rate); };
    return int(begin(i + 1) - begin(i));
}

PngSize size_of(const Picture& picture) {
    return std::visit(
        [](const auto& image) {
            return PngSize{image.width(), image.height()};
        },
        picture);
}

PixelBox changed_box(const Picture& before, const Picture& now) {
    return std::visit(
        [&](const auto& b) {
            const auto& a = std::get<std::decay_t<decltype(b)>>(before);
            const auto [top, bottom] =
                changed_range(b.height(), [&](std::size_t y) { return row_differs(a, b, y); });
            const auto [left, right] =
                changed_range(b.width(), [&](std::size_t x) { return column_differs(a, b, x); });
            return PixelBox{left, top, right - left, bottom - top};
        },
        now);
}

Picture cut(const Picture& picture, const PixelBox& box) {
    return std::visit(
        [&](const auto& image) -> Picture {
            auto part = std::decay_t<decltype(image)>::unset(box.width, box.height);
            for (std::size_t y = 0; y < box.height; ++y)
                std::ranges::copy(image.row(box.y + y).subspan(box.x, box.width),
                                  part.row(y).begin());
            return part;
        },
        picture);
}

}  // namespace burl
