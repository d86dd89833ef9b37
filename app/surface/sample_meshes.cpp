#include "app/surface/sample_meshes.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "app/base/embedded.h"
#include "app/base/messages.h"
#include "atlas/base/error.h"
#include "atlas/mesh/mesh_builder.h"
#include "atlas/read/readers.h"

namespace burl {

namespace {

constexpr std::string_view prefix = "sample:", extension = ".obj";

}  // namespace

bool is_sample_mesh(const std::string& argument) {
    return argument.starts_with(prefix);
}

FileBuffer sample_file(const std::string& argument) {
    const std::string file_name = argument.substr(prefix.size()) + std::string(extension);
    for (const EmbeddedFile& file : embedded_meshes()) {
        if (file.name == file_name) return buffer_from(file.content, file_name);
    }
    const std::vector<std::string> names = sample_mesh_names();
    const std::vector<std::string_view> words(names.begin(), names.end());
    const std::string_view nearest = nearest_word(argument.substr(prefix.size()), words);
    const std::string hint =
        nearest.empty() ? "" : fmt::format("did you mean \"{}{}\"? ", prefix, nearest);
    throw Error(ExitCode::usage, fmt::format("there is no mesh \"{}\"; {}the samples are {}",
                                             argument, hint, fmt::join(names, ", ")));
}

Mesh sample_mesh(const std::string& argument, const ReadOptions& options) {
    const FileBuffer file = sample_file(argument);
    return build_mesh(parse_mesh(file, options), file.path, options);
}

std::vector<std::string> sample_mesh_names() {
    std::vector<std::string> names;
    for (const EmbeddedFile& file : embedded_meshes())
        names.emplace_back(file.name.substr(0, file.name.size() - extension.size()));
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace burl
