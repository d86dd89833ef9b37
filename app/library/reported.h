#pragma once
// Work on a thread of its own, while the caller's thread tells how far it is.
#include <functional>
#include <stop_token>

#include "app/base/course.h"
#include "app/library/error.h"
#include "app/library/progress.h"

namespace burl::library {

/// Work that writes to the course, where there is one, and ends soon after `stop` is requested, by
/// an exception or without a result that is used.
using StoppableWork = std::function<void(const std::stop_token& stop, Course* course)>;

/// Runs the work; with a callback on another thread, and lets what the work or the callback throws
/// through. Throws Error(stopped) where the callback says so.
void run_reported(const Progress& progress, const StoppableWork& work);

/// The result of `make`, which run_reported runs.
template <class Make>
auto made_reported(const Progress& progress, const Make& make) {
    std::optional<decltype(make(std::stop_token(), nullptr))> made;
    run_reported(progress, [&](const std::stop_token& stop, Course* course) {
        made.emplace(make(stop, course));
    });
    return std::move(*made);
}

}  // namespace burl::library
