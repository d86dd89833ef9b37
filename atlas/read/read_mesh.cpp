// Chooses the reader by the file's extension and turns what it parsed into a Mesh.
#include "atlas/read/read_mesh.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include "atlas/base/error.h"
#include "atlas/base/stop.h"
#include "atlas/file/file_extension.h"
#include "atlas/mesh/mesh_builder.h"
#include "atlas/read/readers.h"

namespace burl {
namespace {

using Parser = PolygonSoup (*)(const FileBuffer&, const ReadOptions&);

/// The parser for the path's extension. Throws Error(unsupported) when there is none.
Parser parser_for(const std::string& path) {
    const std::string extension = lower_extension(path);
    if (extension == ".obj") return parse_obj;
    if (extension == ".ply") return parse_ply;
    if (extension == ".stl") return parse_stl;
    if (extension == ".off") return parse_off;
    if (extension == ".gltf" || extension == ".glb") return parse_gltf;
    if (std::error_code ignored; std::filesystem::is_directory(path, ignored))
        throw Error(ExitCode::io, fmt::format("cannot read {}: it is a folder, not a file", path));
    throw Error(ExitCode::unsupported,
                fmt::format("{}: cannot read {}; use .obj, .ply, .stl, .off, .gltf or .glb", path,
                            extension.empty() ? "a mesh without extension"
                                              : fmt::format("'{}' meshes", extension)));
}

/// Throws Error where the file is empty or begins as a file of another format than its name says:
/// as a GLB, as a PLY, or, named as a glTF, as no JSON.
void check_beginning(const FileBuffer& file) {
    if (file.size == 0) throw invalid_file(file.path, 0, "the file is empty");
    const std::string_view text = file.text();
    const std::string extension = lower_extension(file.path);
    const bool gltf = extension == ".gltf" || extension == ".glb";
    if (!gltf && text.starts_with("glTF"))
        throw invalid_file(file.path, 0, "the file is a .glb; name it so");
    if (extension != ".ply" && (text.starts_with("ply\n") || text.starts_with("ply\r")))
        throw invalid_file(file.path, 0, "the file is a .ply; name it so");
    const std::size_t first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
    if (gltf && !text.starts_with("glTF") &&
        (first == text.npos || (text[first] != '{' && text[first] != '[')))
        throw invalid_file(file.path, 0,
                           "the file is no glTF; a .gltf begins with '{' and a .glb with 'glTF'");
}

/// Runs `step`, turning exhausted memory into an Error.
template <typename Step>
auto with_memory_error(const std::string& path, const Step& step) {
    try {
        return step();
    } catch (const std::bad_alloc&) {
        throw Error(ExitCode::runtime, fmt::format("{}: not enough memory to read the mesh", path));
    } catch (const std::length_error&) {
        throw Error(ExitCode::runtime, fmt::format("{}: not enough memory to read the mesh", path));
    }
}

}  // namespace

PolygonSoup parse_mesh(const FileBuffer& file, const ReadOptions& options) {
    const Parser parse = parser_for(file.path);
    check_beginning(file);
    return with_memory_error(file.path, [&] { return parse(file, options); });
}

PolygonSoup parse_mesh(const std::string& path, const ReadOptions& options) {
    parser_for(path);  // an unknown format is reported before a missing file
    return parse_mesh(with_memory_error(path, [&] { return read_file(path, options.named); }),
                      options);
}

void check_mesh_file(const std::string& path) {
    parser_for(path);
    check_file(path);
}

Mesh read_mesh(const std::string& path, const ReadOptions& options, const std::stop_token& stop) {
    parser_for(path);
    FileBuffer file = with_memory_error(path, [&] { return read_file(path, options.named); });
    file.stop = stop;
    check_stop(stop);
    PolygonSoup soup = parse_mesh(file, options);
    return with_memory_error(path,
                             [&] { return build_mesh(std::move(soup), path, options, stop); });
}

}  // namespace burl
