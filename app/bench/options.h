#pragma once
// The options that each suite of `burl bench` accepts: options without effect are refused, and so
// are sizes that a suite cannot hold in memory or in its batches.
#include <string>

#include "app/bench/command.h"

namespace burl {

/// Checks the options given on the command line (with their dashes). Throws Error(usage).
void check_bench(const BenchCommand& command, const std::vector<std::string>& given);

/// Returns the help for --size: unit, bounds and default of each suite.
std::string bench_size_help();

/// Returns the names of the suites, sorted.
std::vector<std::string> bench_suite_names();

}  // namespace burl
