#include "app/bench/bench.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>

#include <fmt/format.h>

#include "app/base/stopwatch.h"
#include "atlas/base/json.h"
#include "procedural/batch/texel_batch.h"
#include "procedural/numbers/simd_target.h"

namespace burl {

namespace {

double median_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

/// Summarises a case's rounds; `first` has the seconds of its group's first case in the same
/// rounds.
BenchRow summarise(const BenchCase& bench, const std::vector<double>& seconds,
                   const std::vector<double>& first) {
    const auto [lowest, highest] = std::minmax_element(seconds.begin(), seconds.end());
    std::vector<double> ratios;
    for (std::size_t i = 0; i < seconds.size(); ++i) ratios.push_back(seconds[i] / first[i]);
    return {bench.name, bench.unit,  bench.units,         median_of(seconds), *lowest,
            *highest,   bench.group, int(seconds.size()), median_of(ratios)};
}

Json finite_or_null(double x) {
    return std::isfinite(x) ? Json(x) : Json();
}

/// Returns the processor's name according to Linux.
std::string processor_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name") && line.find(": ") != std::string::npos)
            return line.substr(line.find(": ") + 2);
    return "unknown";
}

}  // namespace

std::vector<BenchRow> run_paired(const std::vector<BenchCase>& cases, int repeats) {
    std::vector<std::vector<double>> seconds(cases.size());
    for (const BenchCase& bench : cases) bench.run();
    for (int round = 0; round < repeats; ++round) {
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const auto start = std::chrono::steady_clock::now();
            cases[i].run();
            seconds[i].push_back(seconds_since(start));
        }
    }
    std::vector<BenchRow> rows;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto first = std::ranges::find(cases, cases[i].group, &BenchCase::group);
        rows.push_back(
            summarise(cases[i], seconds[i], seconds[std::size_t(first - cases.begin())]));
    }
    return rows;
}

BenchError BenchError::of(std::span<const double> values, std::span<const double> reference) {
    BenchError error;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double e = std::abs(values[i] - reference[i]);
        error.max = std::max(error.max, e);
        error.rms += e * e;
    }
    error.rms = std::sqrt(error.rms / double(values.size()));
    return error;
}

double BenchError::psnr() const {
    return -20.0 * std::log10(rms);
}

Json result_json(const BenchResult& result) {
    const BenchRow& time = result.time;
    const bool timed = time.rounds > 0;
    const double ns = 1e9 / time.units;
    Json json{{"group", time.group}, {"method", time.name}, {"unit", time.unit}};
    json["ns_median"] = timed ? Json(ns * time.median) : Json();
    json["ns_lowest"] = timed ? Json(ns * time.lowest) : Json();
    json["ns_highest"] = timed ? Json(ns * time.highest) : Json();
    json["times_first"] = timed ? Json(time.times_first) : Json();
    json["error_max"] = result.error ? finite_or_null(result.error->max) : Json();
    json["error_rms"] = result.error ? finite_or_null(result.error->rms) : Json();
    json["psnr"] = result.error ? finite_or_null(result.error->psnr()) : Json();
    if (result.texels_per_span) json["texels_per_span"] = *result.texels_per_span;
    return json;
}

Json machine_json() {
    return {{"cpu", processor_name()},
            {"threads", std::thread::hardware_concurrency()},
            {"simd", simd_level()}};
}

std::string result_table(std::span<const BenchResult> results) {
    std::size_t widest = 10;
    for (const BenchResult& r : results) widest = std::max(widest, r.time.name.size());
    std::string text;
    const std::string* group = nullptr;
    for (const BenchResult& r : results) {
        const BenchRow& t = r.time;
        if (group == nullptr || *group != t.group) {
            text += fmt::format("{}{:<{}} {:>10} {:>21} {:>8} {:>10} {:>10} {:>7}\n",
                                group == nullptr ? "" : "\n", t.group, widest, "ns/" + t.unit,
                                "lowest - highest", "x first", "max error", "RMS error", "PSNR");
            if (r.texels_per_span)
                text += fmt::format("{:.1f} texels per span on average\n", *r.texels_per_span);
            group = &t.group;
        }
        text += fmt::format("{:<{}}", t.name, widest);
        if (t.rounds > 0)
            text += fmt::format(" {:>10.2f} {:>10.2f} {:>10.2f} {:>8.2f}", t.ns_per_unit(),
                                t.lowest * 1e9 / t.units, t.highest * 1e9 / t.units, t.times_first);
        else
            text += fmt::format(" {:>10} {:>10} {:>10} {:>8}", "-", "-", "-", "-");
        if (r.error)
            text += fmt::format(" {:>10.3g} {:>10.3g} {:>7.1f}\n", r.error->max, r.error->rms,
                                r.error->psnr());
        else
            text += fmt::format(" {:>10} {:>10} {:>7}\n", "-", "-", "-");
    }
    return text;
}

}  // namespace burl
