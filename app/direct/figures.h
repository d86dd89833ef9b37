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
    /// A figure's parts may also be such that no command draws them (drawn_part.h).
    std::vector<std::string> parts;

    /// Whether the parts are arguments of `burl render --direct`.
    bool has_commands() const;
};

/// The largest size of a figure's file, in bytes.
inline constexpr std::size_t figure_limit = 100'000;

std::vector<Figure> figures();

/// The figure of this name. Throws Error(usage) listing the figures where there is none.
Figure find_figure(const std::string& name);

/// The picture of one part: that of drawn_part(), or the result of the options and the code of
/// `burl render --direct`.
Image<Rgb8> draw_part(const std::string& arguments);

/// The picture of all parts in rows, with white between them.
Image<Rgb8> draw_figure(const Figure& figure);

}  // namespace burl
