#include "app/options/noise_options.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/options/command_options.h"
#include "app/recipe/parameters.h"
#include "atlas/base/error.h"
#include "procedural/noise/domain_warp.h"
#include "procedural/noise/names.h"

namespace burl {

namespace {

template <NamedEnum Enum>
CLI::Validator word_of() {
    return one_of({enum_names<Enum>.begin(), enum_names<Enum>.end()});
}

/// Accepts the range that recipes give the parameter of a noise term.
CLI::Validator range_of(std::string_view key) {
    const auto* parameter = find_parameter(fmt::format("texture.input.noise.0.{}", key));
    return in_range(parameter->low, parameter->high);
}

Error wrong_usage(const std::string& sentence) {
    return Error(ExitCode::usage, sentence);
}

std::string dimensions_of(NoiseKind kind) {
    std::vector<std::size_t> all;
    for (std::size_t n = 1; n <= 4; ++n)
        if (has_dimensions(kind, n)) all.push_back(n);
    return fmt::format("{} to {}", all.front(), all.back());
}

/// The sum of all octaves, the first with `seed`.
template <class Real, std::size_t N>
NoiseSample<Real, N> sum_octaves(const NoiseOptions& options, std::uint32_t seed,
                                 const Point<N>& p) {
    return fractal_sum<Real>(options.fractal, p, [&](std::uint32_t k, const Point<N>& q) {
        NoiseSpec octave = options.noise;
        octave.seed = seed + k;
        for (std::uint32_t& period : octave.period)
            period = std::uint32_t(period * std::pow(options.fractal.lacunarity, k));
        return sample_noise<Real>(octave, q);
    });
}

}  // namespace

void NoiseOptions::add(CLI::App& verb) {
    verb.add_option("--noise", kind_, "One noise instead of a recipe (`burl list noises`)")
        ->check(word_of<NoiseKind>());
    verb.add_option("--fade", fade_, "value: linear, smooth or quintic")
        ->check(word_of<Fade>())
        ->capture_default_str();
    verb.add_option("--feature", feature_, "worley: f1, f2 or f2-f1")
        ->check(word_of<WorleyFeature>())
        ->capture_default_str();
    verb.add_option("--radius2", noise.radius2, "simplex in 3-D: squared radius of the kernels")
        ->check(range_of("radius2"))
        ->capture_default_str();
    verb.add_option("--seed", noise.seed, "Number of the random lattice")->capture_default_str();
    verb.add_option("--period", period_,
                    "Cells after which the noise repeats, one number or one per axis; 0 for never")
        ->delimiter(',')
        ->expected(1, 4)
        ->check(CLI::Range(std::uint32_t(0), largest_period));
    verb.add_option("--sum", sum_, "What octaves add: fbm, turbulence or ridged")
        ->check(word_of<OctaveShape>())
        ->capture_default_str();
    verb.add_option("--octaves", fractal.octaves, "Octaves that are summed")
        ->check(CLI::Range(1, 24))
        ->capture_default_str();
    verb.add_option("--lacunarity", fractal.lacunarity, "Frequency ratio between octaves")
        ->check(range_of("lacunarity"))
        ->capture_default_str();
    verb.add_option("--gain", fractal.gain, "Amplitude ratio between octaves")
        ->check(range_of("gain"))
        ->capture_default_str();
    verb.add_flag("--normalized", fractal.normalized, "Divide the sum by its weights' sum");
    verb.add_option("--warp", warp, "Cells by which noises of the same kind move the point")
        ->check(in_range(-1e3, 1e3))
        ->capture_default_str();
}

void NoiseOptions::check_given(const CLI::App& verb) const {
    const auto refuse = [&](const char* option, bool idle, const char* of) {
        if (idle && verb.count(option) > 0)
            throw wrong_usage(fmt::format("{} is of {}; leave it out", option, of));
    };
    for (const char* option : {"--fade", "--feature", "--radius2", "--seed", "--period", "--sum",
                               "--octaves", "--lacunarity", "--gain", "--normalized", "--warp"})
        refuse(option, !given(), "--noise, and recipes have numbers of their own (--set)");
    refuse("--fade", kind_ != "value", "value noise");
    refuse("--feature", kind_ != "worley", "worley noise");
    refuse("--radius2", kind_ != "simplex", "simplex noise");
    for (const char* option : {"--lacunarity", "--gain", "--normalized"})
        refuse(option, fractal.octaves == 1, "several octaves (--octaves)");
}

void NoiseOptions::resolve(std::size_t dimensions) {
    noise.kind = *enum_named<NoiseKind>(kind_);
    noise.fade = *enum_named<Fade>(fade_);
    noise.feature = *enum_named<WorleyFeature>(feature_);
    fractal.shape = *enum_named<OctaveShape>(sum_);
    if (!has_dimensions(noise.kind, dimensions))
        throw wrong_usage(fmt::format("{} noise has {} dimensions, the points have {}", kind_,
                                      dimensions_of(noise.kind), dimensions));
    if (period_.empty()) return;
    if (period_.size() == 1) period_.resize(dimensions, period_[0]);
    if (period_.size() != dimensions)
        throw wrong_usage(fmt::format("--period has {} numbers, the points have {} coordinates",
                                      period_.size(), dimensions));
    for (std::size_t axis = 0; axis < dimensions; ++axis) {
        const std::uint32_t period = noise.period[axis] = period_[axis];
        if (!has_period(noise.kind, dimensions, period))
            throw wrong_usage("simplex noise repeats in 3 dimensions only, after multiples of 3");
        if (period != 0 && fractal.octaves > 1 &&
            fractal.lacunarity != std::floor(fractal.lacunarity))
            throw wrong_usage("--period needs a whole --lacunarity");
        if (period * std::pow(fractal.lacunarity, fractal.octaves - 1.0) > double(largest_period))
            throw wrong_usage(
                fmt::format("--period exceeds {} cells in the last octave; ask for fewer octaves",
                            largest_period));
    }
}

template <class Real, std::size_t N>
NoiseSample<Real, N> sample_noise(const NoiseOptions& options, const Point<N>& p) {
    const std::uint32_t seed = options.noise.seed;
    if (options.warp == 0.0) return sum_octaves<Real>(options, seed, p);
    return domain_warp<Real>(
        p, options.warp,
        [&](std::size_t axis, const Point<N>& q) {
            return sum_octaves<Real>(options, seed + 100 * (std::uint32_t(axis) + 1), q);
        },
        [&](const Point<N>& q) { return sum_octaves<Real>(options, seed, q); });
}

template NoiseSample<float, 1> sample_noise(const NoiseOptions&, const Point<1>&);
template NoiseSample<float, 2> sample_noise(const NoiseOptions&, const Point<2>&);
template NoiseSample<float, 3> sample_noise(const NoiseOptions&, const Point<3>&);
template NoiseSample<float, 4> sample_noise(const NoiseOptions&, const Point<4>&);
template NoiseSample<double, 1> sample_noise(const NoiseOptions&, const Point<1>&);
template NoiseSample<double, 2> sample_noise(const NoiseOptions&, const Point<2>&);
template NoiseSample<double, 3> sample_noise(const NoiseOptions&, const Point<3>&);
template NoiseSample<double, 4> sample_noise(const NoiseOptions&, const Point<4>&);

}  // namespace burl
