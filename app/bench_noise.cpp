// Values are taken at points in no order; those of the vectorised kernels along lines of 256, as
// in a bake, their positions worked out in the time.
#include "app/bench_noise.h"

#include <algorithm>
#include <memory>
#include <random>

#include <fmt/format.h>

#include "app/bench_baselines.h"
#include "procedural/noise.h"
#include "procedural/noise_kernels.h"
#include "procedural/noise_names.h"

namespace burl {

namespace {

constexpr double reach = 64.0;  // cells from the origin
constexpr std::size_t line_length = 256;

/// Cases of a suite with what they compute and what they should.
struct NoiseCases {
    using Values = std::shared_ptr<std::vector<double>>;
    std::vector<BenchCase> cases;
    std::vector<Values> values;
    std::vector<std::shared_ptr<const std::vector<double>>> references;  ///< null: none

    /// run(values) fills as many values as there are points.
    template <class Run>
    void add(const std::string& group, const std::string& name, std::size_t count,
             std::shared_ptr<const std::vector<double>> reference, const Run& run) {
        auto out = std::make_shared<std::vector<double>>(count);
        cases.push_back({name, double(count), "sample", [out, run] { run(out->data()); }, group});
        values.push_back(out);
        references.push_back(std::move(reference));
    }
};

using Points = std::shared_ptr<const std::vector<Vec3d>>;
using Lines = std::shared_ptr<const std::vector<LatticeLine>>;

Points random_points(std::size_t count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-reach, reach);
    auto points = std::make_shared<std::vector<Vec3d>>(count);
    for (Vec3d& p : *points) p = {place(random), place(random), place(random)};
    return points;
}

/// A tenth of a cell from texel to texel, on the average.
Lines random_lines(std::size_t count) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> place(-reach, reach), step(-0.1, 0.1);
    auto lines = std::make_shared<std::vector<LatticeLine>>(count / line_length);
    for (LatticeLine& line : *lines) {
        line.start = {place(random), place(random), place(random)};
        line.step = {step(random), step(random), step(random)};
        line.count = line_length;
    }
    return lines;
}

Points points_of(const std::vector<LatticeLine>& lines) {
    auto points = std::make_shared<std::vector<Vec3d>>();
    for (const LatticeLine& line : lines)
        for (std::size_t j = 0; j < line.count; ++j)
            points->push_back(line.start + double(j) * line.step);
    return points;
}

std::shared_ptr<const std::vector<double>> reference(const NoiseSpec& noise, const Points& points) {
    auto values = std::make_shared<std::vector<double>>();
    for (const Vec3d& p : *points) values->push_back(evaluate_noise(noise, p));
    return values;
}

void add_scalar(NoiseCases& all, const std::string& group, const std::string& name,
                const NoiseSpec& noise, const Points& points) {
    const auto exact = reference(noise, points);
    all.add(group, name + ", float32", points->size(), exact, [noise, points](double* out) {
        for (const Vec3d& p : *points)
            *out++ = double(noise_value<float, 3>(noise, {p.x, p.y, p.z}));
    });
    all.add(group, name + ", float64", points->size(), exact, [noise, points](double* out) {
        for (const Vec3d& p : *points) *out++ = evaluate_noise(noise, p);
    });
}

void add_kernel(NoiseCases& all, const std::string& group, const std::string& name,
                const NoiseSpec& noise, const Lines& lines) {
    const auto batch = std::make_shared<LatticeBatch>();
    constexpr std::size_t at_once = batch_capacity / line_length;
    const std::size_t count = lines->size() * line_length;
    all.add(group, name + ", float32 vectors", count, reference(noise, points_of(*lines)),
            [noise, lines, batch](double* out) {
                double sums[batch_capacity + batch_padding];
                for (std::size_t i = 0; i + at_once <= lines->size(); i += at_once) {
                    split_lattice_lines({lines->data() + i, at_once}, *batch);
                    std::fill(std::begin(sums), std::end(sums), 0.0);
                    add_noise(noise.kind, noise.fade, noise.seed, 1.0, *batch, batch_capacity,
                              sums);
                    out = std::copy_n(sums, batch_capacity, out);
                }
            });
}

void add_ours(NoiseCases& all, const Points& points, const Lines& lines) {
    for (const auto& fade : fade_names) {
        NoiseSpec noise;
        noise.kind = NoiseKind::value;
        noise.fade = fade.value;
        const std::string name = fmt::format("value {}", fade.name);
        add_scalar(all, "value", name, noise, points);
        add_kernel(all, "value", name, noise, lines);
    }
    for (const auto& kind : noise_kinds) {
        if (kind.value == NoiseKind::value) continue;
        NoiseSpec noise;
        noise.kind = kind.value;
        const bool random = kind.value == NoiseKind::cell || kind.value == NoiseKind::white ||
                            kind.value == NoiseKind::worley;
        const std::string group = random ? "random and distances" : "gradient";
        add_scalar(all, group, std::string(kind.name), noise, points);
        if (kind.value == NoiseKind::perlin)
            add_kernel(all, group, std::string(kind.name), noise, lines);
    }
}

}  // namespace

std::vector<BenchResult> bench_noise(int repeats, std::size_t samples) {
    const std::size_t count = samples / batch_capacity * batch_capacity;
    const Points points = random_points(count);
    NoiseCases all;
    add_ours(all, points, random_lines(count));
    for (const BenchBaseline& baseline : bench_baselines())
        all.add(baseline.group, baseline.name, count, nullptr,
                [baseline, points](double* out) { baseline.run(*points, out); });
    const std::vector<BenchRow> times = run_paired(all.cases, repeats);
    std::vector<BenchResult> results;
    for (std::size_t i = 0; i < times.size(); ++i) {
        results.push_back({times[i]});
        if (all.references[i])
            results.back().error = BenchError::of(*all.values[i], *all.references[i]);
    }
    std::ranges::stable_sort(results, {}, [](const BenchResult& r) {
        return r.time.group == "value" ? 0 : r.time.group == "gradient" ? 1 : 2;
    });
    return results;
}

}  // namespace burl
