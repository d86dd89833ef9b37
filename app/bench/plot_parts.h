#pragma once
// What the pictures of reports have in common: logarithmic axes with a grid, markers, and panels in
// rows over a legend. Everything is placed by arithmetic on the widths that text has at most, so
// that nothing overlaps in any viewer's fonts.
#include <optional>
#include <string>
#include <vector>

#include "app/base/json_text.h"

namespace burl {

inline constexpr double plot_width = 300, plot_height = 230;  ///< of a panel, inside its frame

/// Decades from the first to the last.
struct DecadeAxis {
    int low = 0, high = 1;
    /// Where a value above 0 lies on a stretch of that length.
    double place(double value, double length) const;
    /// Over values above 0, at least one.
    static DecadeAxis over(const std::vector<double>& values);
};

struct PlotAxes {
    DecadeAxis x, y;
    std::string x_title, y_title;
    double inset = 0.0;  ///< what y leaves free at the top and at the bottom of the panel

    double x_of(double value) const { return x.place(value, plot_width); }
    double y_of(double value) const {
        return plot_height - inset - y.place(value, plot_height - 2 * inset);
    }
};

/// Frame, lines at every decade, labels and titles; the panel's own title above.
std::string plot_grid(const PlotAxes& axes, const std::string& title);

/// A palette for colour-blind readers (Okabe & Ito), over and over.
std::string plot_color(std::size_t method);

/// The method's colour and shape at (x, y); the shape changes when the colours have run out, too.
/// `best` has a black rim.
std::string plot_marker(std::size_t method, double x, double y, bool best);

/// The number at a row's key, if it is one.
std::optional<double> number_at(const Json& row, const char* key);
/// The text there, or nothing.
std::string text_at(const Json& row, const char* key);

struct PlotPage {
    std::vector<std::string> panels;   ///< insides, in their own coordinates
    std::vector<std::string> methods;  ///< of the legend
    bool numbered = false;             ///< whether markers have the methods' numbers beside them
};

/// A whole document: suite and machine, `note`, the panels, the legend.
std::string plot_document(const Json& report, const std::string& note, const PlotPage& page);

/// The index of `one` in `all`, where it is put if it was not there.
template <class T>
std::size_t index_in(std::vector<T>& all, const T& one) {
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i] == one) return i;
    all.push_back(one);
    return all.size() - 1;
}

}  // namespace burl
