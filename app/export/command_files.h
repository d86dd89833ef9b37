#pragma once
// The files of one command. No output may replace an input or another output; symbolic links and
// other spellings of a path count as the same file.
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/recipe/recipe.h"
#include "atlas/base/named_files.h"

namespace burl {

/// A set of files, by real path and, for existing ones, by device and inode.
class FileNames {
  public:
    /// Adds a file; `note` is the caller's, for messages. A path that is known keeps its first name
    /// and note; another hard link of a known file gets its own.
    void add(const std::string& path, std::string note = {});

    struct Known {
        std::string name;  ///< the path as it was given
        std::string note;
    };
    /// The entry of the file or one of its hard links; null where it was not added.
    const Known* find(const std::string& path) const;
    /// The entry of the real path alone, for files that are replaced: their other hard links stay
    /// unchanged.
    const Known* find_path(const std::string& path) const;

  private:
    std::vector<Known> known_;
    std::map<std::string, std::size_t> by_path_;  ///< indices into known_, by real path
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::size_t> by_inode_;
};

/// The inputs and outputs of a command, checked before any work.
class CommandFiles {
  public:
    CommandFiles() = default;
    /// A command with files that were checked already.
    CommandFiles(FileNames read, FileNames written)
        : read_(std::move(read)), written_(std::move(written)) {}

    /// Allows outputs in folders that are missing, which the caller makes.
    void allow_new_folders() { new_folders_ = true; }

    /// Adds inputs, which may be known already. Throws Error(io) for one that is an output.
    void read(std::span<const std::string> paths);

    /// Adds an output. Throws Error: usage where the name does not end in `extension` (in lower
    /// case; empty: any); io where the name is too long, the folder is missing or not writable,
    /// where something else than a regular file has the name, or where the file is an input or
    /// another output.
    void write(const std::string& path, std::string_view extension = {});

    /// Throws Error(io) where the file is an input or an output.
    void check(const std::string& path) const;

  private:
    FileNames read_, written_;
    bool new_folders_ = false;
};

/// Throws Error(usage) where files beside the output, which name others after it, would name what
/// readers do not find: a backslash begins a folder's name to some of them, and a line ends at a
/// control character.
void check_scene_name(const std::string& out);

enum class MeshFiles {
    read,   ///< the files that the mesh is made of: its own and a glTF's buffers
    named,  ///< besides those of `read`, images of a glTF, and an OBJ's libraries with pictures
};

/// The files of a mesh, of a glTF those that `named` lets be read; empty for a sample mesh or an
/// empty path. Errors of reading are left to the mesh's reader.
std::vector<std::string> files_of_mesh(const std::string& mesh_path,
                                       MeshFiles which = MeshFiles::named,
                                       NamedFiles named = NamedFiles::below);

/// Whether an output that keeps the rest of the mesh's file may name the files that that names: the
/// images of a glTF, in a .gltf, or the material libraries of an OBJ.
bool keeps_file_names(const std::string& mesh_path, const std::string& out_path);

/// The paths of the images of a recipe and its bumps, which are relative to the folder of its file;
/// each once.
std::vector<std::string> images_of_recipe(const std::string& path_or_preset, const Recipe& recipe);

/// The images of a recipe, and its own file unless it is a preset.
std::vector<std::string> files_of_recipe(const std::string& path_or_preset, const Recipe& recipe);

}  // namespace burl
