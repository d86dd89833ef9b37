#pragma once
// The files of one command: no output may replace a file that is read, nor another output. Links
// and other spellings of a file are that file.
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/recipe/recipe.h"

namespace burl {

/// Files by their real path and, where they are there, by device and inode.
class FileNames {
  public:
    /// `note` is the caller's, for messages. A path that is known keeps its first name and note;
    /// another hard link of a known file has its own.
    void add(const std::string& path, std::string note = {});

    struct Known {
        std::string name;  ///< as it was given
        std::string note;
    };
    /// Null for a file that was not added.
    const Known* find(const std::string& path) const;
    /// By real path alone, for files that are replaced: their other hard links stay as they are.
    const Known* find_path(const std::string& path) const;

  private:
    std::vector<Known> known_;
    std::map<std::string, std::size_t> by_path_;  ///< into known_
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::size_t> by_inode_;
};

class CommandFiles {
  public:
    CommandFiles() = default;
    /// Of files that were checked already.
    CommandFiles(FileNames read, FileNames written)
        : read_(std::move(read)), written_(std::move(written)) {}

    /// Files that are read, those already known included. Throws Error(io) for one that is written.
    void read(std::span<const std::string> paths);

    /// A file that will be written. Throws Error before any work: usage where its name does not end
    /// in `extension` (in lower case; empty: any); io where its folder is missing or not writable,
    /// where something else than a regular file has its name, or for a file that is read or written
    /// already.
    void write(const std::string& path, std::string_view extension = {});

  private:
    FileNames read_, written_;
};

enum class MeshFiles {
    read,   ///< the mesh is made of these: its own file and a glTF's buffers
    named,  ///< these must stay besides: images of a glTF and material libraries of an OBJ
};

/// None for a sample mesh or an empty path. What cannot be read is left for the reader to report.
std::vector<std::string> files_of_mesh(const std::string& mesh_path,
                                       MeshFiles which = MeshFiles::named);

/// The images a recipe reads, its bumps' included, from the folder of its file on.
std::vector<std::string> images_of_recipe(const std::string& path_or_preset, const Recipe& recipe);

/// Those images and the recipe's own file, if it has one and is no preset.
std::vector<std::string> files_of_recipe(const std::string& path_or_preset, const Recipe& recipe);

}  // namespace burl
