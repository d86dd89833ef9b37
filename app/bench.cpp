#include "app/bench.h"

#include <algorithm>
#include <chrono>

namespace burl {

namespace {

double seconds_of(const std::function<void()>& run) {
    const auto start = std::chrono::steady_clock::now();
    run();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

BenchRow summarise(const BenchCase& bench, std::vector<double> seconds) {
    std::sort(seconds.begin(), seconds.end());
    const std::size_t n = seconds.size();
    const double median = n % 2 == 1 ? seconds[n / 2] : 0.5 * (seconds[n / 2 - 1] + seconds[n / 2]);
    return {bench.name, bench.unit, bench.units, median, seconds.front(), seconds.back()};
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
        rows.push_back(summarise(cases[i], std::move(seconds[i])));
    }
    return rows;
}

}  // namespace burl
