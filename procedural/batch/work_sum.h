#pragma once
// Adds up what the threads of a synthesis did: whole numbers, so that nobody's order counts.
#include <mutex>

#include "procedural/batch/economy.h"

namespace burl {

class WorkSum {
  public:
    /// Adds to `total`; null: nobody wants to know.
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
