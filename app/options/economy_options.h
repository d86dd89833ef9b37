#pragma once
// Options about work that a texture can do without: --no-skip and --cache.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "procedural/batch/economy.h"

namespace CLI {
class App;
}

namespace burl {

struct EconomyOptions {
    std::vector<std::string> forbidden;     ///< of skip_names, or all_skips
    std::optional<double> cache_megabytes;  ///< of 1024^2 bytes

    /// --no-skip.
    void add_skips(CLI::App& verb);
    /// --cache.
    void add_cache(CLI::App& verb);

    Skips skips() const;
    /// Bytes to keep where `several` textures of one atlas will be made. For a single one nothing
    /// is kept unless it was asked for.
    std::size_t cache_bytes(bool several) const;
};

/// --no-skip's word for every one of skip_names.
inline constexpr const char* all_skips = "all";

}  // namespace burl
