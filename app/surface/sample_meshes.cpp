#include "app/surface/sample_meshes.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "app/base/embedded.h"
#include "app/base/messages.h"
#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"
#include "atlas/mesh/mesh_builder.h"
#include "atlas/read/readers.h"

namespace burl {

namespace {

constexpr std::string_view prefix = "sample:", extension = ".obj";

/// The OBJ of "sample:NAME". Throws Error(usage) listing the samples where there is none of that
/// name.
const EmbeddedFile& embedded_sample(const std::string& argument) {
    const std::string file_name = argument.substr(prefix.size()) + std::string(extension);
    for (const EmbeddedFile& file : embedded_meshes())
        if (file.name == file_name) return file;
    const std::vector<std::string> names = sample_mesh_names();
    const std::string_view nearest = nearest_word(argument.substr(prefix.size()), names);
    const std::string hint =
        nearest.empty() ? "" : fmt::format("did you mean \"{}{}\"? ", prefix, nearest);
    throw Error(ExitCode::usage, fmt::format("there is no mesh \"{}\"; {}the samples are {}",
                                             argument, hint, fmt::join(names, ", ")));
}

FileBuffer sample_file(const std::string& argument) {
    const EmbeddedFile& file = embedded_sample(argument);
    return buffer_from(file.content, std::string(file.name));
}

}  // namespace

bool is_sample_mesh(const std::string& argument) {
    return argument.starts_with(prefix);
}

Mesh sample_mesh(const std::string& argument, const ReadOptions& options) {
    const FileBuffer file = sample_file(argument);
    return build_mesh(parse_mesh(file, options), file.path, options);
}

void check_mesh_argument(const std::string& argument) {
    if (is_sample_mesh(argument))
        embedded_sample(argument);
    else
        check_mesh_file(argument);
}

FileBuffer mesh_bytes(const std::string& path, NamedFiles named) {
    return is_sample_mesh(path) ? sample_file(path) : read_file(path, named);
}

std::vector<std::string> sample_mesh_names() {
    std::vector<std::string> names;
    for (const EmbeddedFile& file : embedded_meshes())
        names.emplace_back(file.name.substr(0, file.name.size() - extension.size()));
    std::sort(names.begin(), names.end());
    return names;
}

bool is_pose_file(const std::string& pose) {
    const std::vector<std::string> extensions = mesh_extensions();
    return is_sample_mesh(pose) ||
           std::ranges::find(extensions, lower_extension(pose)) != extensions.end();
}

MeshPose load_pose(const std::string& mesh, const std::string& pose, const ReadOptions& options) {
    const FileBuffer file = mesh_bytes(mesh, options.named);
    return is_pose_file(pose) ? read_pose(file, mesh_bytes(pose, options.named), options)
                              : read_own_pose(file, pose, options);
}

std::vector<std::string> poses_of(const std::string& mesh) {
    if (is_sample_mesh(mesh)) return {};
    try {
        return pose_names(read_file(mesh));
    } catch (const Error&) {
        return {};
    }
}

std::vector<std::string> sentences_of(const MeshNotes& notes) {
    const struct {
        std::uint64_t count;
        const char *one, *many, *fate;
    } counts[] = {
        {notes.degenerate_triangles, "triangle", "triangles",
         "without area (kept; nothing to texture)"},
        {notes.duplicate_triangles, "duplicate triangle", "duplicate triangles", "(kept)"},
        {notes.unreferenced_points, "point", "points", "that no face uses (left out)"},
        {notes.ignored_elements, "element", "elements", "other than faces (not read)"},
    };
    std::vector<std::string> sentences;
    for (const auto& [count, one, many, fate] : counts)
        if (count != 0)
            sentences.push_back(fmt::format("{} {} {}", count, count == 1 ? one : many, fate));
    sentences.insert(sentences.end(), notes.sentences.begin(), notes.sentences.end());
    return sentences;
}

}  // namespace burl
