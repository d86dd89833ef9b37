#pragma once
// Kernels on one of the machine's instruction sets at a time.
#include <hwy/highway.h>

namespace burl {

/// Restricts Highway to one instruction set while it lives.
class OnlyTarget {
  public:
    explicit OnlyTarget(std::int64_t target) { choose(target); }
    ~OnlyTarget() { choose(0); }
    OnlyTarget(const OnlyTarget&) = delete;
    OnlyTarget& operator=(const OnlyTarget&) = delete;

  private:
    static void choose(std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
};

/// Calls test() once on every instruction set that kernels are compiled for and the machine has.
template <class Test>
void on_every_target(const Test& test) {
    for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
        const OnlyTarget only(left & -left);
        test();
    }
}

}  // namespace burl
