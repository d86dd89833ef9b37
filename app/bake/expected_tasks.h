#pragma once
// What a bake's tasks after the synthesis are expected to take, for the time that is left.
#include <vector>

#include "app/bake/bake.h"
#include "app/base/progress.h"

namespace burl {

/// The tasks of a round of the plan from the synthesis on, in their order.
std::vector<ExpectedTask> expected_tasks(const BakePlan& plan, const Recipe& recipe);

}  // namespace burl
