#pragma once
// Requests that long work ends early.
#include <stop_token>

#include "atlas/base/error.h"

namespace burl {

/// Throws Error(runtime) where a stop has been requested.
inline void check_stop(const std::stop_token& stop) {
    if (stop.stop_requested()) throw Error(ExitCode::runtime, "stopped before it was done");
}

}  // namespace burl
