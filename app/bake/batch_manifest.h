#pragma once
// The manifest of `burl batch`, a list of bakes in JSON. An entry is one `burl bake`, with the
// options' long names as keys, so that both verbs share the options and their checks:
//   {"defaults": {"size": 1024},
//    "bakes": [{"mesh": "a.obj", "recipe": "marble", "output": "a.png"}, ...]}
// Relative paths start at the manifest's folder.
#include <cstddef>
#include <string>
#include <vector>

#include "app/bake/options.h"
#include "atlas/base/json.h"

namespace burl {

/// One bake of a manifest.
struct BatchEntry {
    std::string where;  ///< prefix of messages: "batch.json:7: bake 2 (a.png)"
    BakeCommand command{};
    Json settings{};    ///< settings of the command (bake_settings)
    std::string wrong;  ///< error of the entry, one sentence; empty: none
};

/// Part `part` of `parts` of a list, from 0 on; parts differ by at most one element.
struct BatchShard {
    std::size_t part = 0, parts = 1;

    std::size_t first(std::size_t count) const { return begin_of(part, count); }
    std::size_t last(std::size_t count) const { return begin_of(part + 1, count); }

  private:
    std::size_t begin_of(std::size_t i, std::size_t count) const {
        return count / parts * i + count % parts * i / parts;
    }
};

/// Parses "I/N", I from 1 to N; an empty text is the whole. Throws Error(usage) for anything else.
BatchShard batch_shard(const std::string& text);

/// Wrong bakes after which no more are looked at: lists in an entry make thousands of one mistake.
inline constexpr std::size_t most_wrong_bakes = 100;

/// The bakes of the manifest `path` ("-": of stdin, relative paths from the working directory on),
/// in its order, those of a matrix (app/bake/batch_matrix.h) one after the other, each parsed as
/// `burl bake` parses its options; an entry's error is stored in it (BatchEntry::wrong). Throws
/// Error(io), or Error(invalid_file) with "file:line: ..." for a manifest that is not an object
/// with a list of entries.
///
/// Only those of the shard are parsed, up to the wrong one number most_wrong_bakes; their files may
/// lie where `named` says.
std::vector<BatchEntry> read_manifest(const std::string& path, const BatchShard& shard = {},
                                      NamedFiles named = NamedFiles::below);

/// The bakes of a matrix that a command line gives: meshes or patterns of them, and options as
/// KEY=VALUE or KEY alone, of which several with one KEY are a list.
std::vector<BatchEntry> matrix_of_options(const std::vector<std::string>& meshes,
                                          const std::vector<std::string>& options,
                                          const BatchShard& shard = {});

}  // namespace burl
