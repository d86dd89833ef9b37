#pragma once
// Tests of kernels on one instruction set of the machine at a time.
#include "procedural/numbers/simd_target.h"

namespace burl {

/// Calls test() once on every instruction set that the kernels are compiled for and the machine
/// supports.
template <class Test>
void on_every_target(const Test& test) {
    for (const std::string& target : simd_targets()) {
        const OnlySimdTarget only(target);
        test();
    }
}

}  // namespace burl
