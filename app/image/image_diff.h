#pragma once
// How far two pictures are apart: figures over sRGB-encoded values in 0..1, and a false-colour
// picture of where (docs/reference/rendering.md). `burl diff` prints and writes these.
#include <cstdint>
#include <optional>

#include "atlas/base/image.h"

namespace burl {

struct DiffOptions {
    double tolerance = 0.0;  ///< in 0..1; pixels with a channel off by more are counted
    double scale = 0.0625;   ///< the difference that the false-colour picture's ramp ends at, > 0
    /// Pixels where either picture has exactly this colour are left out: with the renderers'
    /// background, what remains is the surface both pictures show.
    std::optional<Rgb8> ignore = std::nullopt;
};

struct ImageDiff {
    double psnr_db = 0.0;       ///< 10 log10(1 / mean square over all channels); may be inf
    double maximum = 0.0;       ///< largest channel difference, 0..1
    double rmse = 0.0;          ///< root mean square over all channels, 0..1
    std::uint64_t pixels = 0;   ///< compared
    std::uint64_t ignored = 0;  ///< left out by DiffOptions::ignore
    std::uint64_t above_tolerance = 0;
    Image<Rgb8> false_color;  ///< largest channel difference through a ramp from black to white

    bool within(double tolerance) const { return maximum <= tolerance; }
};

/// Throws Error(invalid_file) when the sizes differ. With no pixel compared the figures are those
/// of identical pictures.
ImageDiff diff_images(const Image<Rgb8>& a, const Image<Rgb8>& b, const DiffOptions& options = {});

/// The ramp: position 0 black, 1/4 blue, 1/2 magenta, 3/4 orange, 1 and above white.
Rgb8 false_color(double position);

}  // namespace burl
