#pragma once
// The manifest of `burl batch`, a list of bakes in JSON. An entry is one `burl bake`, with the
// options' long names as keys, so that both verbs share the options and their checks:
//   {"defaults": {"size": 1024},
//    "bakes": [{"mesh": "a.obj", "recipe": "marble", "output": "a.png"}, ...]}
// Relative paths start at the manifest's folder.
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/bake/options.h"

namespace burl {

/// One bake of a manifest.
struct BatchEntry {
    std::string where;  ///< prefix of messages: "batch.json:7: bake 2 (a.png)"
    BakeCommand command{};
    Json settings{};    ///< settings of the command (bake_settings)
    std::string wrong;  ///< error of the entry, one sentence; empty: none
};

/// The bakes of the manifest `path` ("-": of stdin, relative paths from the working directory on),
/// in its order, those of a matrix (app/bake/batch_matrix.h) one after the other, each parsed as
/// `burl bake` parses its options; an entry's error is stored in it (BatchEntry::wrong). Throws
/// Error(io), or Error(invalid_file) with "file:line: ..." for a manifest that is not an object
/// with a list of entries.
std::vector<BatchEntry> read_manifest(const std::string& path);

/// The bakes of a matrix that a command line gives: meshes or patterns of them, and options as
/// KEY=VALUE or KEY alone, of which several with one KEY are a list.
std::vector<BatchEntry> matrix_of_options(const std::vector<std::string>& meshes,
                                          const std::vector<std::string>& options);

}  // namespace burl
