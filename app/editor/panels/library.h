#pragma once
// The library: every material and every figure of the papers that Burl brings, as pictures in
// categories, with a search and the favourites of whoever works here.
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "app/editor/panels/panels.h"

namespace burl {

/// Returns a recipe's thumbnail, side x side pixels; null: not ready.
using PresetPicture = std::function<ImTextureID(const std::string& name, int side)>;

/// The part of the library that is shown.
struct LibraryView {
    std::string search{};
    std::string category{};   ///< a category's name; empty: all
    bool favourites = false;  ///< whether only favourites are shown
};

/// A recipe of the library.
struct LibraryEntry {
    std::string name, about, category;
};

/// The category of what is in no group: the figures of the papers and tests of patterns.
inline constexpr const char* classics = "classic";

/// All that fits the view, the categories one after another.
std::vector<LibraryEntry> library_entries(const LibraryView& view,
                                          const std::set<std::string>& favourites);

/// The categories in the order in which they are shown.
std::vector<std::string> library_categories();

/// Draws the library; a click on a picture opens its recipe, one on its star makes it a favourite
/// or takes that back. Items are "preset:NAME" and "favourite:NAME" for all that is visible,
/// "category:NAME" and "category:all", "library favourites" and "preset search".
void library_panel(const PanelContext& context, LibraryView& view,
                   std::set<std::string>& favourites, const PresetPicture& picture);

}  // namespace burl
