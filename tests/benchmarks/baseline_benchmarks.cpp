#include <random>

#include <fmt/format.h>

#include "app/bench/noise.h"
#include "tests/benchmarks/micro_benchmarks.h"

namespace burl {

void register_baseline_benchmarks() {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-32.0, 32.0);
    auto points = std::make_shared<std::vector<Vec3d>>(batch_capacity);
    for (Vec3d& p : *points) p = {place(random), place(random), place(random)};
    for (const BenchBaseline& baseline : bench_baselines(points))
        register_batch(fmt::format("{}/{}", baseline.group, baseline.name), baseline.run);
}

}  // namespace burl
