#pragma once
// Some rows of an image, computed apart from the others: a texture of 16384 x 16384 float pixels
// takes three gigabytes, of which a file that is written row by row needs few rows at a time.
#include <algorithm>
#include <cstddef>
#include <limits>

#include "atlas/base/image.h"

namespace burl {

/// Rows [first, end) of an image; all rows by default.
struct RowWindow {
    std::size_t first = 0, end = std::numeric_limits<std::size_t>::max();

    /// The window clipped to an image of `rows` rows.
    RowWindow of(std::size_t rows) const { return {std::min(first, rows), std::min(end, rows)}; }
    std::size_t count() const { return end - first; }
};

/// An image of some rows of a larger one; pixels are named by their coordinates in the larger one.
template <class Pixel>
struct RowBand {
    Image<Pixel>& image;
    std::size_t first = 0;  ///< the row of the larger image that is row 0 of `image`

    Pixel& operator()(std::size_t x, std::size_t y) const { return image(x, y - first); }
    RowWindow rows() const { return {first, first + image.height()}; }
};

template <class Pixel>
RowBand(Image<Pixel>&) -> RowBand<Pixel>;
template <class Pixel>
RowBand(Image<Pixel>&, std::size_t) -> RowBand<Pixel>;

}  // namespace burl
