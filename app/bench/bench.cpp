#include "app/bench/bench.h"

#include <algorithm>
#include <chrono>

namespace burl {

namespace {

double seconds_of(const std::function<void()>& run) {
    const auto start = std::chrono::steady_clock::now();
    run();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

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

}  // namespace

std::vector<BenchRow> run_paired(const std::vector<BenchCase>& cases, int repeats) {
    std::vector<std::vector<double>> seconds(cases.size());
    for (const BenchCase& bench : cases) bench.run();
    for (int round = 0; round < repeats; ++round) {
        for (std::size_t i = 0; i < cases.size(); ++i)
            seconds[i].push_back(seconds_of(cases[i].run));
    }
    std::vector<BenchRow> rows;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto first = std::ranges::find(cases, cases[i].group, &BenchCase::group);
        rows.push_back(
            summarise(cases[i], seconds[i], seconds[std::size_t(first - cases.begin())]));
    }
    return rows;
}

}  // namespace burl
