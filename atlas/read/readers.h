#pragma once
// The readers behind read_mesh(), one per format. Each parses a whole file in memory and throws
// Error(invalid_file) with the line (text) or the vertex's or face's number (binary) of what is
// wrong.
#include "atlas/file/file_buffer.h"
#include "atlas/mesh/polygon_soup.h"
#include "atlas/read/read_mesh.h"

namespace burl {

PolygonSoup parse_obj(const FileBuffer& file, const ReadOptions& options = {});
PolygonSoup parse_off(const FileBuffer& file, const ReadOptions& options = {});
PolygonSoup parse_ply(const FileBuffer& file, const ReadOptions& options = {});
PolygonSoup parse_stl(const FileBuffer& file, const ReadOptions& options = {});
PolygonSoup parse_gltf(const FileBuffer& file, const ReadOptions& options = {});

/// What a pose of its own (atlas/gltf/pose.h) makes of the file's meshes, in the same order of
/// faces and corners; meshes that it does not move stay as they are. Normals that a morph target
/// says nothing of are zero. Throws Error(usage), with the names there are, where there is no such
/// pose.
PolygonSoup parse_gltf_pose(const FileBuffer& file, const std::string& pose,
                            const ReadOptions& options);

/// The first half of read_mesh(): reads and parses `path` by its extension, with read_mesh()'s
/// errors. build_mesh() is the second half.
PolygonSoup parse_mesh(const std::string& path, const ReadOptions& options = {});

/// The same for a file in memory, by the extension of `file.path`.
PolygonSoup parse_mesh(const FileBuffer& file, const ReadOptions& options = {});

}  // namespace burl
