#pragma once
// What a person sets once and finds again at the next start: the theme, where the splitters are,
// favourite materials and the up axis of meshes, kept in the user's state folder.
#include <map>
#include <set>
#include <string>

#include "app/base/json_text.h"

namespace burl {

/// Colours of the user interface.
enum class Theme { dark, light };

/// The sizes of the editor's parts, as shares; the defaults are those of a first start.
struct PaneShares {
    double side = 0.0;   ///< the side panel's share of the window's width; 0: by the text's size
    double atlas = 0.5;  ///< the atlas's share of the view that it has in common with the object
    /// The timeline's share of the window's height; 0: as high as its rows.
    double timeline = 0.0;
    double graph = 0.5;  ///< the graph's share of the height that it has in common with the object
    bool operator==(const PaneShares&) const = default;
};

/// Preferences as one comparable value.
struct EditPreferences {
    Theme theme = Theme::dark;
    PaneShares panes{};
    std::set<std::string> favourites{};  ///< names of materials, presets and recipe files
    /// Whether the first steps were closed, and are no more offered at the start.
    bool welcomed = false;
    /// The up axis of meshes where it is not y, by the mesh's path: "z" or "-z".
    std::map<std::string, std::string> up_axes{};
    bool operator==(const EditPreferences&) const = default;
};

/// Preferences as JSON, without what is as by default.
Json to_json(const EditPreferences& preferences);
/// Reads preferences from JSON; what has no meaning is left as by default.
EditPreferences preferences_from_json(const Json& json);

/// The preferences' file. All functions are called by one thread.
class PreferenceFile {
  public:
    /// Reads `file`; an empty name, or one that cannot be read, gives the defaults. An empty name
    /// is never written.
    explicit PreferenceFile(std::string file);

    const EditPreferences& stored() const { return stored_; }
    /// Writes what differs from the last call or the start, over what other editors wrote into the
    /// file meanwhile. A file that cannot be written is no longer stored, without a message.
    void store(const EditPreferences& now);

  private:
    Json read() const;

    std::string file_;
    EditPreferences stored_;
};

}  // namespace burl
