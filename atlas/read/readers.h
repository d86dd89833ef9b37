#pragma once
// The readers behind read_mesh(), one per format. Each parses a whole file in memory and throws
// Error(invalid_file) with the number of the wrong line (text), vertex or face (binary).
#include "atlas/file/file_buffer.h"
#include "atlas/mesh/polygon_soup.h"
#include "atlas/read/read_mesh.h"

namespace burl {

PolygonSoup parse_obj(const FileBuffer& file, const ReadOptions& options = {});
PolygonSoup parse_off(const FileBuffer& file, const ReadOptions& options = {});
PolygonSoup parse_ply(const FileBuffer& file, const ReadOptions& options = {});
PolygonSoup parse_stl(const FileBuffer& file, const ReadOptions& options = {});
PolygonSoup parse_gltf(const FileBuffer& file, const ReadOptions& options = {});

/// The file's meshes in one of the file's own poses (atlas/gltf/pose.h), with faces and corners in
/// parse_gltf()'s order; meshes that the pose does not move stay as they are. Normals are zero
/// where a morph target has none. Throws Error(usage), with the names of the existing poses, where
/// there is no such pose.
PolygonSoup parse_gltf_pose(const FileBuffer& file, const std::string& pose,
                            const ReadOptions& options);

/// The first half of read_mesh(): reads and parses `path` by its extension, with read_mesh()'s
/// errors. build_mesh() is the second half.
PolygonSoup parse_mesh(const std::string& path, const ReadOptions& options = {});

/// Parses a file in memory by the extension of `file.path`, with read_mesh()'s errors.
PolygonSoup parse_mesh(const FileBuffer& file, const ReadOptions& options = {});

}  // namespace burl
