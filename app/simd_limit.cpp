#include "app/simd_limit.h"

#include <cstdint>

#include <fmt/format.h>
#include <hwy/highway.h>

#include "atlas/error.h"

namespace burl {

void limit_simd(const std::string& level) {
    std::string names;
    for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
        const std::int64_t target = left & -left;
        if (hwy::TargetName(target) == level) {
            hwy::SetSupportedTargetsForTest(target);
            hwy::GetChosenTarget().Update(hwy::SupportedTargets());
            return;
        }
        names += fmt::format("{}{}", names.empty() ? "" : ", ", hwy::TargetName(target));
    }
    throw Error(ExitCode::usage,
                fmt::format("--simd {}: must be one of this machine's, {}", level, names));
}

}  // namespace burl
