#include "app/sample_meshes.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "app/embedded.h"
#include "atlas/error.h"
#include "atlas/mesh_builder.h"
#include "atlas/mesh_readers.h"

namespace burl {

namespace {

constexpr std::string_view prefix = "sample:", extension = ".obj";

}  // namespace

bool is_sample_mesh(const std::string& argument) {
    return argument.starts_with(prefix);
}

Mesh sample_mesh(const std::string& argument, const ReadOptions& options) {
    const std::string file_name = argument.substr(prefix.size()) + std::string(extension);
    for (const EmbeddedFile& file : embedded_meshes()) {
        if (file.name != file_name) continue;
        return build_mesh(parse_mesh(buffer_from(file.content, file_name), options), file_name,
                          options);
    }
    throw Error(ExitCode::usage, fmt::format("there is no mesh \"{}\"; the samples are {}",
                                             argument, fmt::join(sample_mesh_names(), ", ")));
}

std::vector<std::string> sample_mesh_names() {
    std::vector<std::string> names;
    for (const EmbeddedFile& file : embedded_meshes())
        names.emplace_back(file.name.substr(0, file.name.size() - extension.size()));
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace burl
