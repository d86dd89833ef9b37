#pragma once
// What a file's name says about its format; upper and lower case are the same.
#include <string>
#include <vector>

namespace burl {

/// With its dot and in lower case (ASCII); empty where there is none.
std::string lower_extension(const std::string& path);

/// Whether the name ends in .gltf or .glb.
bool has_gltf_extension(const std::string& path);

/// Of the meshes that can be read.
std::vector<std::string> mesh_extensions();

}  // namespace burl
