#include "app/export/command_files.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

#include "app/base/json_text.h"
#include "app/export/export.h"
#include "app/recipe/presets.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "atlas/base/real_path.h"
#include "atlas/file/file_buffer.h"
#include "atlas/file/file_extension.h"
#include "atlas/gltf/container.h"
#include "atlas/read/obj_libraries.h"

namespace burl {

namespace {

namespace fs = std::filesystem;

using Inode = std::pair<std::uint64_t, std::uint64_t>;

std::optional<Inode> inode_of(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return std::nullopt;
    return Inode(status.st_dev, status.st_ino);
}

void check_output_folder(const std::string& path) {
    const fs::path folder = fs::path(path).parent_path();
    const std::string name = folder.empty() ? "." : folder.string();
    std::error_code failure;
    const fs::file_status status = fs::status(name, failure);
    if (!fs::exists(status)) {
        throw Error(ExitCode::io, fmt::format("{}: the folder {} does not exist", path, name));
    }
    if (!fs::is_directory(status)) {
        throw Error(ExitCode::io, fmt::format("{}: {} is not a folder", path, name));
    }
    if (::access(name.c_str(), W_OK | X_OK) != 0) {
        throw Error(ExitCode::io, fmt::format("{}: the folder {} cannot be written to: {}", path,
                                              name, std::generic_category().message(errno)));
    }
}

/// The path of a file in the nearest of the file's folders that exists.
std::string in_existing_folder(const std::string& path) {
    fs::path file(path);
    std::error_code ignored;
    while (!file.parent_path().empty() && file.parent_path() != file &&
           !fs::exists(file.parent_path(), ignored))
        file = file.parent_path();
    return file.string();
}

/// File systems have room for names of so many bytes (limits.h of Linux).
constexpr std::size_t longest_name = 255;

void check_output_name(const std::string& path) {
    const std::size_t bytes = fs::path(path).filename().string().size();
    if (bytes > longest_name)
        throw Error(ExitCode::io,
                    fmt::format("{}: its name has {} bytes, and files have {} at most; give the "
                                "output a shorter name",
                                path, bytes, longest_name));
}

void check_output_file(const std::string& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (!fs::exists(status)) return;
    if (fs::is_directory(status)) {
        throw Error(ExitCode::io, fmt::format("{}: is a folder, not a file", path));
    }
    if (!fs::is_regular_file(status)) {
        throw Error(ExitCode::io, fmt::format("{}: is not a regular file", path));
    }
}

[[noreturn]] void refuse_overwriting(const std::string& path, const std::string& other,
                                     std::string_view why) {
    if (path == other)
        throw Error(
            ExitCode::io,
            fmt::format("{}: this command {} that file; give the output another name", path, why));
    throw Error(ExitCode::io,
                fmt::format("{}: would overwrite {}, which this command {}; give it another name",
                            path, other, why));
}

/// Appends the files that a glTF's list of buffers or images names.
void add_named_by_uri(const Json& document, const char* list, const fs::path& folder,
                      NamedFiles named, std::vector<std::string>& files) {
    if (!document.is_object() || !document.contains(list)) return;
    for (const Json& item : document[list]) {
        if (!item.is_object() || !item.contains("uri") || !item["uri"].is_string()) continue;
        const auto uri = item["uri"].get<std::string>();
        const std::string name = is_data_uri(uri) ? "" : confined_file_name(uri, named);
        if (!name.empty()) files.push_back((folder / name).string());
    }
}

/// Appends the buffer files of a glTF, and its image files where `all` is set.
void add_named_by_gltf(const std::string& path, bool all, NamedFiles named,
                       std::vector<std::string>& files) {
    const FileBuffer file = read_file(path);
    const Json document = Json::parse(split_gltf(file).json, nullptr, false);
    const fs::path folder = fs::path(path).parent_path();
    add_named_by_uri(document, "buffers", folder, named, files);
    if (all) add_named_by_uri(document, "images", folder, named, files);
}

/// Appends the pictures of a material library that are there, in its folder or that of the OBJ.
/// Others cannot be overwritten, and a small file may name many.
void add_pictures_of(const std::string& library, const fs::path& obj_folder,
                     std::vector<std::string>& files) {
    const FileBuffer file = read_file(library);
    std::set<fs::path> known;
    for (const std::string& name : pictures_of_library(file.text()))
        for (const fs::path& folder : {fs::path(library).parent_path(), obj_folder}) {
            std::error_code ignored;
            const fs::path picture = folder / name;
            if (known.insert(picture).second && fs::exists(picture, ignored))
                files.push_back(picture.string());
        }
}

/// Appends the material libraries of an OBJ that are there, and the pictures of those that `named`
/// lets be read.
void add_named_by_obj(const std::string& path, NamedFiles named, std::vector<std::string>& files) {
    const fs::path folder = fs::path(path).parent_path();
    std::set<std::string> known;
    for (const std::string& name : libraries_of(read_file(path))) {
        const std::string library = (folder / name).string();
        std::error_code ignored;
        if (!fs::exists(library, ignored) || !known.insert(real_path(library)).second) continue;
        files.push_back(library);
        if (!may_name(named, path, name)) continue;
        try {
            add_pictures_of(library, folder, files);
        } catch (const Error&) {
        }
    }
}

}  // namespace

void FileNames::add(const std::string& path, std::string note) {
    const std::size_t index = known_.size();
    if (!by_path_.emplace(real_path(path), index).second) return;
    known_.push_back({path, std::move(note)});
    if (const auto inode = inode_of(path)) by_inode_.emplace(*inode, index);
}

const FileNames::Known* FileNames::find_path(const std::string& path) const {
    const auto found = by_path_.find(real_path(path));
    return found == by_path_.end() ? nullptr : &known_[found->second];
}

const FileNames::Known* FileNames::find(const std::string& path) const {
    if (const Known* known = find_path(path)) return known;
    if (const auto inode = inode_of(path))
        if (const auto found = by_inode_.find(*inode); found != by_inode_.end())
            return &known_[found->second];
    return nullptr;
}

void CommandFiles::read(std::span<const std::string> paths) {
    for (const std::string& path : paths) {
        if (const auto* other = written_.find(path)) refuse_overwriting(other->name, path, "reads");
        read_.add(path);
    }
}

void CommandFiles::write(const std::string& path, std::string_view extension) {
    if (!extension.empty() && lower_extension(path) != extension) {
        throw Error(ExitCode::usage,
                    fmt::format("{}: the name must end in {}, which is what is written there", path,
                                extension));
    }
    check_output_name(path);
    check_output_folder(new_folders_ ? in_existing_folder(path) : path);
    check_output_file(path);
    check(path);
    written_.add(path);
}

void CommandFiles::check(const std::string& path) const {
    if (const auto* other = read_.find(path)) refuse_overwriting(path, other->name, "reads");
    if (const auto* other = written_.find_path(path))
        refuse_overwriting(path, other->name, "also writes");
}

void check_scene_name(const std::string& out) {
    const std::string name = fs::path(out).filename().string();
    const auto unreadable = [](char c) { return c == '\\' || (c >= 0 && c < ' ') || c == '\x7f'; };
    const bool names_others = lower_extension(out) == ".gltf" || lower_extension(out) == ".obj";
    if (names_others && std::ranges::any_of(name, unreadable))
        throw Error(ExitCode::usage,
                    fmt::format("{}: the files beside it are named after it, and other programs do "
                                "not find names with a backslash or a control character; give it "
                                "another name, or write a .glb",
                                out));
}

std::vector<std::string> files_of_mesh(const std::string& mesh_path, MeshFiles which,
                                       NamedFiles named) {
    if (mesh_path.empty() || is_sample_mesh(mesh_path)) return {};
    std::vector<std::string> files{mesh_path};
    const bool all = which == MeshFiles::named;
    try {
        if (has_gltf_extension(mesh_path)) add_named_by_gltf(mesh_path, all, named, files);
        if (all && lower_extension(mesh_path) == ".obj") add_named_by_obj(mesh_path, named, files);
    } catch (const Error&) {
    }
    return files;
}

bool keeps_file_names(const std::string& mesh_path, const std::string& out_path) {
    if (is_sample_mesh(mesh_path)) return false;
    if (has_gltf_extension(mesh_path)) return lower_extension(out_path) == ".gltf";
    return lower_extension(mesh_path) == ".obj" && is_obj(out_path);
}

std::vector<std::string> images_of_recipe(const std::string& path_or_preset, const Recipe& recipe) {
    std::vector<std::string> files;
    const fs::path folder = fs::path(recipe_file(path_or_preset)).parent_path();
    for (const TextureGraph* graph : {&recipe.texture, &recipe.bump.input})
        for (const GraphImage& image : graph->images) {
            std::string file = (folder / image.file).string();
            if (std::ranges::find(files, file) == files.end()) files.push_back(std::move(file));
        }
    return files;
}

std::vector<std::string> files_of_recipe(const std::string& path_or_preset, const Recipe& recipe) {
    std::vector<std::string> files = images_of_recipe(path_or_preset, recipe);
    if (!path_or_preset.empty() && !names_preset(path_or_preset))
        files.push_back(recipe_file(path_or_preset));
    return files;
}

}  // namespace burl
