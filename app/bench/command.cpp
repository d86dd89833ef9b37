#include "app/bench/command.h"

#include <nlohmann/json.hpp>

#include "app/bench/result.h"

namespace burl {

void write_report(const BenchCommand& command, const Json& rows) {
    const Json report = {{"suite", command.suite},
                         {"repeats", command.repeats},
                         {"machine", machine_json()},
                         {"rows", rows},
                         {"versions", versions_json()}};
    if (!command.out.empty()) write_json(command.out, report);
    if (command.json) write_json("-", report);
}

}  // namespace burl
