#pragma once
// File formats told by a file's extension; upper and lower case are the same.
#include <string>
#include <vector>

namespace burl {

/// The path's extension with its dot, in lower case (ASCII); empty where there is none.
std::string lower_extension(const std::string& path);

/// Whether the name ends in .gltf or .glb.
bool has_gltf_extension(const std::string& path);

/// Extensions of the mesh formats that read_mesh() takes, each with its dot, in lower case.
std::vector<std::string> mesh_extensions();

}  // namespace burl
