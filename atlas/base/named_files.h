#pragma once
// Files that a user's file names: the buffers of a glTF, the materials of an OBJ, the images of a
// recipe, the meshes of a manifest. Whoever sends a file to a farm could have it read any other
// that the farm may read; so such names lead out of the file's folder only where the caller says
// so.
#include <string>

namespace burl {

/// Where files that a file names may lie: in its folder and below, or anywhere.
enum class NamedFiles { below, anywhere };

/// Whether `name`, looked for from the folder of `file` on, lies in that folder or below it.
/// Symbolic links count as what they end at, which need not exist.
bool lies_below(const std::string& file, const std::string& name);

/// Whether `file` may name `name`, which is looked for from its folder on.
inline bool may_name(NamedFiles named, const std::string& file, const std::string& name) {
    return named == NamedFiles::anywhere || lies_below(file, name);
}

/// The end of a sentence about a name that may_name() refuses.
inline constexpr auto outside_rule =
    "lies outside the folder of the file that names it; put it there, or allow it with "
    "--allow-outside";

}  // namespace burl
