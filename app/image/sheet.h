#pragma once
// Sheets: several pictures of one size side by side in one, each with its name below it.
#include <cstddef>
#include <string>
#include <vector>

#include "app/image/frame_writer.h"

namespace burl {

/// A grid of cells that are filled row by row.
struct SheetGrid {
    std::size_t columns = 1, rows = 1;
    std::size_t cell_width = 0, cell_height = 0;  ///< in pixels, names included
    std::size_t text_scale = 1;                   ///< pixels per dot of a name's letters

    PngSize size() const { return {columns * cell_width, rows * cell_height}; }
};

/// The grid for `count` pictures, at least 1, of this size in pixels, in `columns` columns; 0 for
/// about as many rows as columns.
SheetGrid sheet_grid(std::size_t count, std::size_t columns, const PngSize& picture);

/// The pictures, one per name, on their grid; all have one size and kind. What none of them covers
/// has the colour of the first picture's first pixel. Names are of printable ASCII; what does not
/// fit below its picture is cut off.
Picture sheet_of(const std::vector<Picture>& pictures, const std::vector<std::string>& names,
                 const SheetGrid& grid);

}  // namespace burl
