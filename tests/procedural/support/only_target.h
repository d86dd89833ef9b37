#pragma once
// Kernels on one of the machine's instruction sets at a time.
#include "procedural/numbers/simd_target.h"

namespace burl {

/// Calls test() once on every instruction set that kernels are compiled for and the machine has.
template <class Test>
void on_every_target(const Test& test) {
    for (const std::string& target : simd_targets()) {
        const OnlySimdTarget only(target);
        test();
    }
}

}  // namespace burl
