#pragma once
// What a bake's tasks are expected to take, for the time that is left.
#include <vector>

#include "app/bake/bake.h"

namespace burl {

/// The tasks of a round of the plan, in their order; a plan without paths writes nothing. Those of
/// large textures are tried first (app/bake/trial.h). `pipeline` is that of the bake, and `recipe`
/// that of its first frame.
std::vector<ExpectedTask> expected_tasks(const BakePlan& plan, const Recipe& recipe,
                                         Pipeline& pipeline);

}  // namespace burl
