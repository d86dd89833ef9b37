#pragma once
// Noise along the scan line of "Bresenham Noise" (Kameya & Hart, figures 9 to 11), texel by texel
// and by forward differences, and plots of both.
#include <cstddef>
#include <span>
#include <vector>

#include "app/direct/forward_cube.h"
#include "atlas/base/image.h"
#include "procedural/model/octaves.h"

namespace burl {

/// The number of texels of the line, which runs from (0, 0, 0) to (2, 2, 2).
inline constexpr std::size_t line_texels = 256;

/// The sum of the octaves at the line's texels; texel j lies at 2 j / line_texels on each axis. By
/// forward differences each octave has its own, which start anew only in its next cell.
std::vector<double> noise_on_line(std::span<const Octave> octaves, CubeMethod method);

/// The texels at which the line enters a cell of the octave, the first one among them, in order.
std::vector<std::size_t> cell_entries(const Octave& octave);

/// A plot 280 pixels wide and 110 high on white, a pixel a texel: the line of zero in grey, dashed
/// lines where cells begin, and curves over one another, the first one broad and light, the second
/// thin and black.
class LinePlot {
  public:
    static constexpr std::size_t width = 280, height = 110, left = 12, middle = 55;
    /// The number of pixels from the zero line to `largest`.
    static constexpr double reach = 50.0;

    /// Starts an empty plot of values from -largest to largest.
    explicit LinePlot(double largest);
    void dash(std::size_t texel);
    void add_broad(std::span<const double> values);
    void add_thin(std::span<const double> values);
    const Image<Rgb8>& picture() const { return picture_; }

  private:
    std::size_t row_of(double value) const;
    void add(std::span<const double> values, std::size_t more, const Rgb8& color);

    double largest_;
    Image<Rgb8> picture_;
};

}  // namespace burl
