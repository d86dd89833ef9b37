#pragma once
// What a recipe was looked at on, and from where, as a text beside its autosave.
#include <optional>
#include <string>

#include "app/editor/jobs/open_files.h"
#include "app/editor/tools/view.h"

namespace burl {

/// Returns "y", "z" or "-z", and the axis of such a text; y for any other text.
std::string to_text(UpAxis up);
UpAxis up_axis_from(const std::string& text);

/// The name by which preferences and autosaves know a mesh: the absolute path of a file, or
/// "sample:NAME".
std::string kept_name(const std::string& mesh);

/// A view of a mesh.
struct KeptView {
    std::string mesh{}, pose{};  ///< as EditOpenFiles takes them; an empty pose: none
    EditCamera camera{};
};
/// The view as text. Empty before the first mesh is open.
std::string view_text(const EditOpenFiles& files, const EditCamera& camera);
/// Reads such a text; no value where it is none.
std::optional<KeptView> kept_view_from(const std::string& text);

}  // namespace burl
