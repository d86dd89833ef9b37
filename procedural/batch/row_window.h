#pragma once
// Some rows of an image that somebody works out apart from the others: a texture of 16384 x 16384
// floats takes three gigabytes, of which a file that is written row by row needs few at a time.
#include <algorithm>
#include <cstddef>
#include <limits>

#include "atlas/base/image.h"

namespace burl {

/// Rows [first, end) of an image; all of them unless said otherwise.
struct RowWindow {
    std::size_t first = 0, end = std::numeric_limits<std::size_t>::max();

    /// Those that an image of so many rows has.
    RowWindow of(std::size_t rows) const { return {std::min(first, rows), std::min(end, rows)}; }
    std::size_t count() const { return end - first; }
};

/// An image of some rows of a larger one, in whose coordinates pixels are named.
template <class Pixel>
struct RowBand {
    Image<Pixel>& image;
    std::size_t first = 0;  ///< the image's first row in the larger one

    Pixel& operator()(std::size_t x, std::size_t y) const { return image(x, y - first); }
    RowWindow rows() const { return {first, first + image.height()}; }
};

template <class Pixel>
RowBand(Image<Pixel>&) -> RowBand<Pixel>;
template <class Pixel>
RowBand(Image<Pixel>&, std::size_t) -> RowBand<Pixel>;

}  // namespace burl
