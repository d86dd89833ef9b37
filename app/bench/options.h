#pragma once
// Which options each suite of `burl bench` has a use for: one that would do nothing is refused, and
// so are sizes that a suite cannot hold in memory or in its batches.
#include <string>

#include "app/bench/command.h"

namespace burl {

/// `given`: the options on the command line, with their dashes. Throws Error(usage).
void check_bench(const BenchCommand& command, const std::vector<std::string>& given);

/// What --size means, suite by suite, with bounds and default.
std::string bench_size_help();

/// The suites, sorted, with `plot`.
std::vector<std::string> bench_suite_names();

}  // namespace burl
