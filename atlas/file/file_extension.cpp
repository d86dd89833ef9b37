#include "atlas/file/file_extension.h"

#include <filesystem>

namespace burl {

std::string lower_extension(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

bool has_gltf_extension(const std::string& path) {
    const std::string extension = lower_extension(path);
    return extension == ".gltf" || extension == ".glb";
}

std::vector<std::string> mesh_extensions() {
    return {".obj", ".ply", ".stl", ".off", ".gltf", ".glb"};
}

}  // namespace burl
