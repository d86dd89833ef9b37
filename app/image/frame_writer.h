#pragma once
// Files of pictures that follow one another: one animation (.webp, .gif, .apng), or a numbered PNG
// per picture. Frames are encoded as they come, and an animation's file is whole or not there
// (app/base/atomic_file.h).
#include <memory>
#include <string>
#include <vector>

#include "app/image/image_io.h"

namespace burl {

/// A picture, with alpha or without.
using Picture = PictureColors;

enum class PictureFormat { png, apng, webp, gif };

/// The format that the path's extension names, in any case. Throws Error(usage) for another one.
PictureFormat picture_format(const std::string& path);

/// Whether all frames go into one file.
inline bool holds_frames(PictureFormat format) {
    return format != PictureFormat::png;
}

/// The quality from which on .webp keeps every code.
inline constexpr int lossless_quality = 100;

/// The speed, and what a file of frames may leave out.
struct FrameFile {
    int frames = 1;      ///< the number of pictures that will be added
    double rate = 24.0;  ///< frames per second, above 0
    int quality = 90;    ///< of .webp, 0 to 100; lossless_quality keeps every code
};

/// A file, or numbered files, that pictures are added to in their order. All pictures are as large
/// as the first, and have alpha or not as it does.
class FrameWriter {
  public:
    virtual ~FrameWriter() = default;
    /// Adds the next picture. Throws Error: io where it cannot be written, unsupported where it is
    /// too large for the format, runtime where the library refuses it.
    virtual void add(const Picture& picture) = 0;
    /// Completes the file and gives it its name, after as many pictures as there are frames. Throws
    /// Error(io).
    virtual void commit() = 0;
};

/// Throws Error(usage) for a rate that the format cannot have: viewers slow a .gif down that has
/// more than 50 frames a second.
void check_rate(const std::string& path, const FrameFile& file);

/// Writers of a single animated file, which plays over and over. A single picture is a still in
/// .webp and .gif. Throws Error: io as AtomicFile does, and as check_rate does.
std::unique_ptr<FrameWriter> webp_writer(const std::string& path, const FrameFile& file);
std::unique_ptr<FrameWriter> gif_writer(const std::string& path, const FrameFile& file);
std::unique_ptr<FrameWriter> apng_writer(const std::string& path, const FrameFile& file);

/// A writer of a PNG per picture, each of which is whole when add() returns.
std::unique_ptr<FrameWriter> png_writer(std::vector<std::string> paths);

/// The writer of the path's format; `paths` has one path per frame for .png, else one alone.
std::unique_ptr<FrameWriter> frame_writer(const std::vector<std::string>& paths,
                                          const FrameFile& file);

/// The duration of frame i in ticks, whole numbers that add up to the time of all frames.
int frame_ticks(int i, double rate, int ticks_per_second);

/// The size of a picture in pixels.
PngSize size_of(const Picture& picture);

/// Whether the picture has alpha.
inline bool has_alpha(const Picture& picture) {
    return std::holds_alternative<Image<Rgba8>>(picture);
}

/// A rectangle of pixels.
struct PixelBox {
    std::size_t x = 0, y = 0, width = 0, height = 0;
};

/// The rectangle of all pixels.
inline PixelBox whole_box(const Picture& picture) {
    const auto [width, height] = size_of(picture);
    return {0, 0, width, height};
}

/// The smallest rectangle outside of which two pictures of one size and kind agree; that of the
/// first pixel where they are equal.
PixelBox changed_box(const Picture& before, const Picture& now);

/// The pixels of the rectangle.
Picture cut(const Picture& picture, const PixelBox& box);

}  // namespace burl
