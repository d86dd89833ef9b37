#pragma once
// The papers' figures as Burl draws them. Every part of a picture is a command line of `burl render
// --direct`, so that readers can draw or change it themselves (docs/guide/figures.md).
#include <cstddef>
#include <string>
#include <vector>

#include "atlas/base/image.h"

namespace burl {

/// A picture of one or more parts in rows.
struct Figure {
    std::string name;   ///< the file's name, without .png
    std::string shows;  ///< one line: the figure that it follows, and its subject
    std::size_t columns = 1;
    /// Arguments of `burl render --direct` except the output, row by row; all parts have one size.
    /// A part may also be "cube RECIPE SIZE pixelwise|forward|difference"
    /// (app/direct/forward_cube.h), which no command draws.
    std::vector<std::string> parts;

    /// Whether the parts are arguments of `burl render --direct`, rather than cubes.
    bool has_commands() const { return !parts.empty() && !parts[0].starts_with("cube "); }
};

/// The largest size of a figure's file, in bytes.
inline constexpr std::size_t figure_limit = 100'000;

std::vector<Figure> figures();

/// The figure of this name. Throws Error(usage) listing the figures where there is none.
Figure find_figure(const std::string& name);

/// The picture of one part: a cube, or the result of the options and the code of `burl render
/// --direct`.
Image<Rgb8> draw_part(const std::string& arguments);

/// The picture of all parts in rows, with white between them.
Image<Rgb8> draw_figure(const Figure& figure);

}  // namespace burl
