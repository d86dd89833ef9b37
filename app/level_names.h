#pragma once
// How files of MIP levels are called beside the texture: a.png, a.1.png, a.2.png, ...
#include <cstddef>
#include <string>

#include <fmt/format.h>

namespace burl {

/// The extension that replaces the texture's own, for level `level` >= 1.
inline std::string level_extension(std::size_t level) {
    return fmt::format(".{}.png", level);
}

}  // namespace burl
