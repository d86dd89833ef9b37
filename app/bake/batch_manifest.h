#pragma once
// The list of bakes that `burl batch` is given. Every entry is one `burl bake`, with the options'
// long names as keys, so that there is one set of options with one set of checks:
//   {"defaults": {"size": 1024},
//    "bakes": [{"mesh": "a.obj", "recipe": "marble", "output": "a.png"}, ...]}
// Files are looked for from the manifest's folder on.
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/bake/options.h"

namespace burl {

struct BatchEntry {
    std::string where;  ///< "batch.json:7: bake 2 (a.png)", for messages
    BakeCommand command{};
    Json settings{};    ///< bake_settings of the command
    std::string wrong;  ///< what is wrong with the entry, one sentence; empty: nothing
};

/// The entries in the manifest's order, each parsed as `burl bake` would parse it: what is wrong
/// with one is in it. Throws Error: io, or invalid_file ("file:line: ...") for a manifest that is
/// no list of entries.
std::vector<BatchEntry> read_manifest(const std::string& path);

}  // namespace burl
