#pragma once
// The papers' figures as we draw them: every part of a picture is a command line of `burl render
// --direct`, so that whoever sees one can draw it, or change it, without us
// (docs/guide/figures.md).
#include <cstddef>
#include <string>
#include <vector>

#include "atlas/base/image.h"

namespace burl {

struct Figure {
    std::string name;   ///< of the file, without .png
    std::string shows;  ///< one line: whose figure it is after, and what it shows
    std::size_t columns = 1;
    /// Arguments of `burl render --direct` but the output, row by row; all parts have one size.
    /// Or "cube RECIPE SIZE pixelwise|forward|difference" (app/direct/forward_cube.h), which is no
    /// command.
    std::vector<std::string> parts;

    bool has_commands() const { return !parts.empty() && !parts[0].starts_with("cube "); }
};

/// Bytes that none of the figures' files exceeds.
inline constexpr std::size_t figure_limit = 100'000;

std::vector<Figure> figures();

/// The figure of that name. Throws Error(usage) with the names there are.
Figure find_figure(const std::string& name);

/// The part that `arguments` ask for: a cube, or by the options and the code of `burl render
/// --direct`.
Image<Rgb8> draw_part(const std::string& arguments);

/// All parts, side by side and row under row, with white between them.
Image<Rgb8> draw_figure(const Figure& figure);

}  // namespace burl
