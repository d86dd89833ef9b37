#pragma once
// Options about computations that a texture may leave out or reuse: --no-skip and --cache.
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
    std::vector<std::string> forbidden;     ///< words of skip_names, or all_skips
    std::optional<double> cache_megabytes;  ///< --cache, in units of 1024^2 bytes

    /// Adds --no-skip.
    void add_skips(CLI::App& verb);
    /// Adds --cache.
    void add_cache(CLI::App& verb);

    Skips skips() const;
    /// The cache size in bytes: the value of --cache, or else 1 GiB where `several` textures of one
    /// atlas will be made and 0 for a single one.
    std::size_t cache_bytes(bool several) const;
};

/// The word of --no-skip that stands for all skip_names.
inline constexpr const char* all_skips = "all";

}  // namespace burl
