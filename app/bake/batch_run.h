#pragma once
// The bakes of a batch, and the order of work: bakes of one mesh run one after another on one
// pipeline, so that the mesh is read once and atlas and solid points are made once for all bakes
// that agree in them.
#include <functional>
#include <string>
#include <vector>

#include "app/bake/job.h"
#include "atlas/base/error.h"

namespace burl {

/// A bake of a batch, with its state.
struct BatchBake {
    std::string where;  ///< its place in the manifest
    BakeJob job;
    std::string status{};  ///< "written", "up to date", "failed" or "planned"
    std::string problem{};
    ExitCode code = ExitCode::ok;
    double seconds = 0.0;
    std::vector<std::string> shared{};  ///< the stages that earlier entries had computed

    /// The outputs, and the record of how they were made.
    std::vector<std::string> files() const;
};

/// Bakes of one mesh, in the order in which they share most.
using BatchGroup = std::vector<BatchBake*>;

/// The bakes in groups, in the order of their first bakes.
std::vector<BatchGroup> batch_groups(std::vector<BatchBake>& bakes);

/// Groups of at most so many bakes, in the same order: each reads its mesh by itself.
std::vector<BatchGroup> split_groups(const std::vector<BatchGroup>& groups, std::size_t most);

/// Whether a bake of the group can reuse synthesis results of the one before or of an earlier
/// frame.
bool has_several_textures(const BatchGroup& group);

/// Runs the bakes of a group whose outputs are not up to date and makes the folders of outputs that
/// are missing; a bake's errors become its state. Calls begins(bake) and done(bake) for each.
void run_group(const BatchGroup& group, const std::function<void(const BatchBake&)>& begins,
               const std::function<void(const BatchBake&)>& done);

}  // namespace burl
