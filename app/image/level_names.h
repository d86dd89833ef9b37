#pragma once
// Names of the files beside a texture: MIP levels a.1.png, a.2.png, ... of a.png, and the normal
// map a_normal.png.
#include <cstddef>
#include <filesystem>
#include <string>

#include <fmt/core.h>

namespace burl {

/// The extension that replaces the texture's own for MIP level `level` >= 1.
inline std::string level_extension(std::size_t level) {
    return fmt::format(".{}.png", level);
}

/// The path of the normal map beside an output file of any kind.
inline std::string normal_map_path(const std::string& out_path) {
    const std::filesystem::path path(out_path);
    return std::filesystem::path(path)
        .replace_filename(path.stem().string() + "_normal.png")
        .string();
}

}  // namespace burl
