#pragma once
// The noise that a node's parameters choose, for every evaluation of graphs.
#include <cmath>

#include "procedural/noise/spec.h"

namespace burl {

/// The noise of the parameters kind, seed, time and time_period; `Call` has parameter(key).
template <class Call>
NoiseSpec noise_of(const Call& call) {
    NoiseSpec noise;
    noise.kind = NoiseKind(int(call.parameter("kind")));
    noise.seed = std::uint32_t(call.parameter("seed"));
    const double time = call.parameter("time");
    if (std::isfinite(time)) {
        noise.time = time;
        noise.period[3] = std::uint32_t(call.parameter("time_period"));
    }
    return noise;
}

}  // namespace burl
