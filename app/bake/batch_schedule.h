#pragma once
// The job queue of `burl batch`: jobs run side by side as long as what they hold fits a budget of
// memory.
#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "app/bake/job.h"

namespace burl {

/// A job of the queue.
struct QueuedJob {
    std::uint64_t bytes = 0;  ///< memory that it holds while it runs
    std::function<void()> run{};
};

/// Runs all jobs, `workers` at a time, each as soon as its bytes and those of the running ones are
/// within the budget; one that is larger than the budget runs alone. Jobs start in their order, but
/// for those that have to wait for memory. Returns when all are done; run() must not throw.
void run_jobs(std::span<const QueuedJob> jobs, int workers, std::uint64_t budget);

/// An upper bound of the bytes that a bake holds at a time, from the size of its mesh's file, the
/// texels and the number of its pictures: docs/lab/batch.md compares it with what was measured.
std::uint64_t bytes_held(const BakeJob& job);

/// Half of the machine's memory, the default budget.
std::uint64_t default_budget();

}  // namespace burl
