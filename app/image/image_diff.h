#pragma once
// The difference of two pictures: figures over sRGB-encoded values in 0..1, and a false-colour
// picture (docs/reference/rendering.md). `burl diff` prints and writes them.
#include <cstdint>
#include <optional>

#include "atlas/base/image.h"

namespace burl {

struct DiffOptions {
    double tolerance = 0.0;  ///< 0..1; pixels with a channel difference above it are counted
    double scale = 0.0625;   ///< the difference, > 0, that the false-colour ramp ends at
    /// Pixels where either picture has exactly this colour are left out. With the renderers'
    /// background here, the pixels compared are those where both pictures show the surface.
    std::optional<Rgb8> ignore = std::nullopt;
};

struct ImageDiff {
    double psnr_db = 0.0;       ///< 10 log10(1 / mean square over all channels); may be inf
    double maximum = 0.0;       ///< largest channel difference, 0..1
    double rmse = 0.0;          ///< root mean square over all channels, 0..1
    std::uint64_t pixels = 0;   ///< the number of pixels compared
    std::uint64_t ignored = 0;  ///< the number of pixels left out by DiffOptions::ignore
    std::uint64_t above_tolerance = 0;
    Image<Rgb8> false_color;  ///< largest channel difference through a ramp from black to white

    bool within(double tolerance) const { return maximum <= tolerance; }
};

/// Compares two pictures of one size. Throws Error(invalid_file) when the sizes differ. Where no
/// pixel is compared the figures are those of identical pictures.
ImageDiff diff_images(const Image<Rgb8>& a, const Image<Rgb8>& b, const DiffOptions& options = {});

/// The colour of a position on the ramp: 0 is black, 1/4 blue, 1/2 magenta, 3/4 orange, 1 white;
/// positions outside [0,1] are clamped.
Rgb8 false_color(double position);

}  // namespace burl
