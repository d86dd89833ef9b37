// Values are computed at points in random order; vectorised kernels compute them along lines of 256
// points, as in a bake, and their times include the positions. The positions for other libraries
// are computed beforehand.
#include "app/bench/noise.h"

#include <algorithm>
#include <memory>
#include <random>

#include <fmt/format.h>

#include "app/bench/command.h"
#include "procedural/field/octave_streams.h"
#include "procedural/noise/names.h"
#include "procedural/noise/noise.h"

namespace burl {

namespace {

constexpr double reach = 64.0;  // distance of the points from the origin in cells
constexpr std::size_t line_length = 256;

/// Cases of a suite with the values they compute and the reference values.
struct NoiseCases {
    using Values = std::shared_ptr<std::vector<double>>;
    std::vector<BenchCase> cases;
    std::vector<Values> values;
    std::vector<std::shared_ptr<const std::vector<double>>> references;  ///< null: no reference
    std::vector<std::function<void()>> finish;  ///< computations after the timing

    /// Adds a case; run(values) must compute `count` values.
    template <class Run>
    void add(const std::string& group, const std::string& name, std::size_t count,
             std::shared_ptr<const std::vector<double>> reference, const Run& run) {
        auto out = std::make_shared<std::vector<double>>(count + batch_padding);
        add_timed(group, name, count, [out, run] { run(out->data()); });
        values.back() = out;
        references.back() = std::move(reference);
    }
    void add_timed(const std::string& group, const std::string& name, std::size_t count,
                   const std::function<void()>& run) {
        cases.push_back({name, double(count), "sample", run, group});
        values.push_back(nullptr);
        references.push_back(nullptr);
        finish.emplace_back([] {});
    }
};

using Lines = std::shared_ptr<const std::vector<Piece>>;

BenchPoints random_points(std::size_t count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-reach, reach);
    auto points = std::make_shared<std::vector<Vec3d>>(count);
    for (Vec3d& p : *points) p = {place(random), place(random), place(random)};
    return points;
}

/// Returns lines whose texels are about a tenth of a cell apart.
Lines random_lines(std::size_t count) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> place(-reach, reach), step(-0.1, 0.1);
    auto lines = std::make_shared<std::vector<Piece>>(count / line_length);
    for (Piece& piece : *lines) {
        piece.solid.start = {place(random), place(random), place(random)};
        piece.solid.step = {step(random), step(random), step(random)};
        piece.solid.count = line_length;
        piece.length = double(line_length);
    }
    return lines;
}

std::shared_ptr<const std::vector<double>> reference(const NoiseSpec& noise,
                                                     const BenchPoints& points) {
    auto values = std::make_shared<std::vector<double>>();
    for (const Vec3d& p : *points) values->push_back(evaluate_noise(noise, p));
    return values;
}

/// Returns the octaves' sum without their offsets, as kernels compute it.
double octave_sum(const std::vector<Octave>& octaves, const Vec3d& s) {
    double sum = 0.0;
    for (const Octave& octave : octaves)
        sum += octave.scale * evaluate_noise(octave.noise, octave.lattice_from_solid(s));
    return sum;
}

std::shared_ptr<const std::vector<double>> reference(const std::vector<Octave>& octaves,
                                                     const std::vector<Piece>& lines) {
    auto values = std::make_shared<std::vector<double>>();
    for (const Piece& piece : lines)
        for (std::size_t j = 0; j < piece.solid.count; ++j)
            values->push_back(
                octave_sum(octaves, piece.solid.start + double(j) * piece.solid.step));
    return values;
}

void add_scalar(NoiseCases& all, const std::string& group, const std::string& name,
                const NoiseSpec& noise, const BenchPoints& points) {
    const auto exact = reference(noise, points);
    all.add(group, name + ", float32", points->size(), exact, [noise, points](double* out) {
        for (const Vec3d& p : *points)
            *out++ = double(noise_value<float, 3>(noise, {p.x, p.y, p.z}));
    });
    all.add(group, name + ", float64", points->size(), exact, [noise, points](double* out) {
        for (const Vec3d& p : *points) *out++ = evaluate_noise(noise, p);
    });
}

/// Adds the vectorised kernel of a noise that has one; every texel hashes its own corners.
void add_kernel(NoiseCases& all, const std::string& group, const std::string& name,
                const std::vector<Octave>& octaves, const Lines& lines) {
    if (!std::ranges::all_of(octaves, has_kernel)) return;
    const auto buffers = std::make_shared<StreamBuffers>();
    constexpr std::size_t at_once = batch_capacity / line_length;
    const std::size_t count = lines->size() * line_length;
    // Batch i is written to out + i * stride. While timing, stride is 0: the output stays in the L1
    // cache, as in a bake.
    const auto run = [streams = OctaveStreams(octaves, Kernel::direct), lines, buffers](
                         double* out, std::size_t stride) {
        for (std::size_t i = 0; i + at_once <= lines->size(); i += at_once) {
            std::fill_n(out, batch_capacity, 0.0);
            streams.add({lines->data() + i, at_once}, batch_capacity, *buffers, out);
            out += stride;
        }
    };
    all.add(group, name + ", float32 vectors", count, reference(octaves, *lines),
            [run](double* out) { run(out, 0); });
    all.finish.back() = [run, out = all.values.back()] { run(out->data(), batch_capacity); };
}

/// Adds cases of four octaves: point by point in float64, and vectorised.
void add_octaves(NoiseCases& all, const std::string& name, const std::vector<Octave>& octaves,
                 const BenchPoints& points, const Lines& lines) {
    auto exact = std::make_shared<std::vector<double>>();
    for (const Vec3d& p : *points) exact->push_back(octave_sum(octaves, p));
    all.add("four octaves", name + ", float64", points->size(), exact,
            [octaves, points](double* out) {
                for (const Vec3d& p : *points) *out++ = octave_sum(octaves, p);
            });
    add_kernel(all, "four octaves", name, octaves, lines);
}

void add_ours(NoiseCases& all, const BenchPoints& points, const Lines& lines) {
    for (const auto& fade : fade_names) {
        NoiseSpec noise;
        noise.kind = NoiseKind::value;
        noise.fade = fade.value;
        const std::string name = fmt::format("value {}", fade.name);
        add_scalar(all, "value", name, noise, points);
        add_kernel(all, "value", name, noise_octaves(noise.kind, noise.fade, 1), lines);
    }
    for (const auto& kind : noise_kinds) {
        if (kind.value == NoiseKind::value) continue;
        NoiseSpec noise;
        noise.kind = kind.value;
        const bool random = kind.value == NoiseKind::cell || kind.value == NoiseKind::white ||
                            kind.value == NoiseKind::worley;
        const std::string group = random ? "random and distances" : "gradient";
        add_scalar(all, group, std::string(kind.name), noise, points);
        add_kernel(all, group, std::string(kind.name), noise_octaves(kind.value, Fade::quintic, 1),
                   lines);
    }
    add_octaves(all, "value smooth", noise_octaves(NoiseKind::value, Fade::smooth, 4), points,
                lines);
    add_octaves(all, "perlin", noise_octaves(NoiseKind::perlin, Fade::quintic, 4), points, lines);
    add_octaves(all, "simplex", noise_octaves(NoiseKind::simplex, Fade::quintic, 4), points, lines);
}

}  // namespace

std::vector<Octave> noise_octaves(NoiseKind kind, Fade fade, std::uint32_t octaves) {
    Texture texture;
    NoiseTerm& term = texture.noise.emplace_back();
    term.kind = kind, term.fade = fade, term.octaves = octaves;
    return expand_octaves(texture);
}

std::vector<BenchResult> bench_noise(int repeats, std::size_t samples) {
    const std::size_t count = samples / batch_capacity * batch_capacity;
    const BenchPoints points = random_points(count);
    NoiseCases all;
    add_ours(all, points, random_lines(count));
    for (const BenchBaseline& baseline : bench_baselines(points))
        all.add_timed(baseline.group, baseline.name, count, baseline.run);
    const std::vector<BenchRow> times = run_paired(all.cases, repeats);
    std::vector<BenchResult> results;
    for (std::size_t i = 0; i < times.size(); ++i) {
        results.push_back({times[i]});
        if (!all.references[i]) continue;
        all.finish[i]();
        all.values[i]->resize(count);
        results.back().error = BenchError::of(*all.values[i], *all.references[i]);
    }
    const std::vector<std::string> order{"value", "gradient", "four octaves"};
    std::ranges::stable_sort(results, {}, [&](const BenchResult& r) {
        return std::ranges::find(order, r.time.group) - order.begin();
    });
    return results;
}

void run_noise_bench(const BenchCommand& command) {
    report_results(command, bench_noise(command.repeats, command.size_or(65536)));
}

}  // namespace burl
