#pragma once
// What `burl bench` was asked for, and the report that every suite ends with.
#include <cstddef>
#include <string>

#include "app/report.h"

namespace burl {

/// `size`: 0 is the suite's own.
struct BenchCommand {
    std::string suite, file, out;
    std::size_t size = 0;
    int repeats = 5;
    bool large = false, json = false;
};

/// Writes the suite's rows with the machine and the versions: to the file asked for, and to stdout
/// with --json.
void write_report(const BenchCommand& command, const Json& rows);

/// The suite `forward`: runs it, prints and reports.
void run_forward_bench(const BenchCommand& command);

}  // namespace burl
