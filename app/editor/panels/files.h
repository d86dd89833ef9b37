#pragma once
// What the editor asks of folders and the names of files.
#include <string>
#include <vector>

namespace burl {

/// An entry of a folder.
struct FolderEntry {
    std::string name;
    bool folder = false;
    bool operator==(const FolderEntry&) const = default;
};

/// Lists a folder: folders first, then files with one of the extensions (lower case, with the dot;
/// none: all), each sorted by name and without hidden ones. Empty where the folder cannot be read.
std::vector<FolderEntry> list_folder(const std::string& folder,
                                     const std::vector<std::string>& extensions);

/// Returns the last part of a path.
std::string file_name(const std::string& path);

/// Creates an empty file "STEM-NNN.EXTENSION" in the working folder with the first free number from
/// 001 on; concurrent programs get different files. Throws Error(io).
std::string claim_numbered(const std::string& stem, const std::string& extension);

/// Returns the path with a leading "~" replaced by the user's home folder, where there is one.
std::string expanded_home(const std::string& path);

}  // namespace burl
