#pragma once
// A sum of SynthesisWork over threads: whole numbers, whose sum does not depend on the order.
#include <mutex>

#include "procedural/batch/economy.h"

namespace burl {

class WorkSum {
  public:
    /// The sum is added to `total`, which may be null.
    explicit WorkSum(SynthesisWork* total) : total_(total) {}

    void add(const SynthesisWork& work) {
        if (!total_) return;
        const std::lock_guard lock(mutex_);
        *total_ += work;
    }

  private:
    std::mutex mutex_;
    SynthesisWork* total_;
};

}  // namespace burl
