#pragma once
// A bake on a thread of its own, while the caller's thread tells how far it is.
#include <functional>
#include <stop_token>

#include "app/library/bake.h"

namespace burl::library {

/// Notes that a stage begins, and the share that is done; throws once the work is to stop.
using Reached = std::function<void(const char* stage, double share)>;
/// Work that notes its stages and ends soon after `stop` is requested.
using StoppableWork = std::function<void(const std::stop_token& stop, const Reached& reached)>;

/// The exception of work that was stopped.
Error stopped();

/// Runs the work; with a callback on another thread, and lets what the work or the callback throws
/// through. Throws Error(stopped) where the callback says so.
void run_reported(const Progress& progress, const StoppableWork& work);

}  // namespace burl::library
