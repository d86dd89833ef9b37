#pragma once
// The command of `burl batch`, and the checks of all its bakes before any of them begins.
#include <string>
#include <vector>

#include "app/bake/batch_manifest.h"
#include "app/bake/batch_run.h"

namespace burl {

/// Values of the options of `burl batch`.
struct BatchCommand {
    std::vector<std::string> what;  ///< a manifest, or meshes
    std::vector<std::string> recipes, sizes, others;
    std::string output;
    int jobs = 0;          ///< number of bakes at a time; 0: one per core
    std::string memory;    ///< the budget; empty: half of what there is
    std::string shard;     ///< I/N: the part that is done; empty: all
    bool dry_run = false;  ///< whether only to say what would be done
    BakeCommand run;       ///< options of add_run_options and add_report_options only

    bool is_manifest() const {
        return what.size() == 1 && (what[0] == "-" || what[0].ends_with(".json"));
    }
    /// The name of what lists the bakes, in messages.
    std::string name() const { return is_manifest() ? what.front() : "batch"; }
    /// The options of the matrix as KEY=VALUE.
    std::vector<std::string> options() const;
};

/// All bakes that the command lists, in its shard. Throws Error where any is wrong, after a line on
/// stderr for each of them; what only reading a mesh tells is not looked for.
std::vector<BatchBake> checked_bakes(const BatchCommand& command);

}  // namespace burl
