// Sums of octaves: where coordinates are split once for several octaves, as noise_sum.h does where
// it has a kernel, and octave by octave elsewhere.
#include <algorithm>

#include <fmt/format.h>

#include "procedural/glsl_noise.h"
#include "procedural/glsl_steps.h"
#include "procedural/noise_names.h"

namespace burl {

namespace {

/// "real3(x, y, z)", times the frequency.
std::string scaled_point(const std::vector<std::string>& inputs, const std::string& frequency) {
    const std::string point =
        inputs == std::vector<std::string>{"solid.x", "solid.y", "solid.z"}
            ? "solid"
            : fmt::format("real3({}, {}, {})", inputs[0], inputs[1], inputs[2]);
    return frequency.empty() ? point : fmt::format("{} * {}", frequency, point);
}

/// A loop from the finest octave, whose amplitude is the least, to the coarsest; one octave needs
/// none.
std::string loop(std::size_t octaves, const std::string& line) {
    if (octaves == 1) return "    " + line;
    return fmt::format("    for (int k = {}; k >= 0; --k){}{}", octaves - 1,
                       line.starts_with('{') ? " " : "\n        ", line);
}

std::string sum_line(const std::string& total, const std::string& weight,
                     const std::string& octave) {
    const bool one = weight == "1.0" || weight == "1.0lf";
    return fmt::format("{0} = {0} + {1}{2};\n", total, one ? "" : weight + " * ", octave);
}

}  // namespace

/// The name of a function for octaves of that noise.
std::string GlslSteps::octave_noise(const NoiseSpec& noise) {
    const auto known = std::find(noises_.begin(), noises_.end(), noise);
    if (known != noises_.end()) return noise_names_[std::size_t(known - noises_.begin())];
    const auto same_kind = std::count_if(noises_.begin(), noises_.end(),
                                         [&](const NoiseSpec& n) { return n.kind == noise.kind; });
    std::string name = "octave_";
    for (const auto& kind : noise_kinds)
        if (kind.value == noise.kind) name += kind.name;
    if (same_kind > 0) name += fmt::format("_{}", same_kind + 1);
    functions_ +=
        has_point_kernel(noise) ? glsl_split_noise(noise, name) : glsl_site_noise(noise, name);
    functions_ += "\n";
    noises_.push_back(noise);
    noise_names_.push_back(name);
    return name;
}

/// The call that shapes an octave.
std::string GlslSteps::shaped(OctaveShape shape, const std::string& value) {
    if (shape == OctaveShape::plain) return value;
    const std::string name = shape == OctaveShape::absolute ? "absolute" : "ridged";
    if (shapes_.insert(shape).second) functions_ += glsl_octave_shape(shape, name) + "\n";
    return fmt::format("{}({})", name, value);
}

/// A constant array before the function; its name.
std::string GlslSteps::array(const char* type, const std::vector<std::string>& values) {
    const std::string list =
        fmt::format("{0}[{1}]({2})", type, values.size(), fmt::join(values, ", "));
    const auto [table, is_new] = tables_.try_emplace(list, fmt::format("table{}", tables_.size()));
    if (is_new)
        functions_ +=
            fmt::format("const {} {}[{}] = {};\n\n", type, table->second, values.size(), list);
    return table->second;
}

/// A number of octave k: an element of a table, or the number itself where there is one octave.
std::string GlslSteps::of_octave(const char* type, const std::vector<std::string>& values) {
    return values.size() > 1 ? array(type, values) + "[k]" : glsl_operand(values[0]);
}

std::string GlslSteps::seed_of_octave(std::span<const SumOctave> octaves) {
    std::vector<std::string> seeds;
    bool follow = true;
    for (const SumOctave& octave : octaves) {
        follow = follow && octave.seed == octaves[0].seed + std::uint32_t(seeds.size());
        seeds.push_back(fmt::format("{}u", octave.seed));
    }
    if (seeds.size() == 1 || !follow) return of_octave("uint", seeds);
    return seeds[0] == "0u" ? "uint(k)" : seeds[0] + " + uint(k)";
}

GlslStep GlslSteps::step(const NoiseSum& sum, const Inputs& inputs) {
    if (sum.octaves.empty()) return {"", {number(sum.offset)}};
    return has_point_kernel(sum.noise) ? split_sum(sum, inputs) : site_sum(sum, inputs);
}

/// Octaves that double one another, from one split point.
std::string GlslSteps::doubling_lines(const NoiseSum& sum, std::span<const SumOctave> octaves,
                                      const Inputs& inputs, const std::string& total) {
    const double frequency = octaves[0].frequency;
    const std::string point = scaled_point(inputs, frequency == 1.0 ? "" : number(frequency));
    const auto [split, is_new] = splits_.try_emplace(point, fmt::format("at{}", splits_.size()));
    std::string lines;
    if (is_new)
        lines = fmt::format("    SplitPoint {} = split_points({}, lattice_limit);\n", split->second,
                            point);
    std::vector<std::string> weights;
    for (const SumOctave& octave : octaves)
        weights.push_back(glsl_number(octave.weight, GlslReal::float32));
    const std::string noise =
        fmt::format("{0}({1}, cells_of({2}, {3}), places_of({2}, {3}))", octave_noise(sum.noise),
                    seed_of_octave(octaves), split->second, octaves.size() > 1 ? "k" : "0");
    return lines + loop(octaves.size(),
                        sum_line(total, of_octave("float", weights), shaped(sum.shape, noise)));
}

/// Octaves in a loop, each from a split point of its own.
std::string GlslSteps::apart_lines(const NoiseSum& sum, const Inputs& inputs,
                                   const std::string& total) {
    std::vector<std::string> weights, frequencies;
    for (const SumOctave& octave : sum.octaves) {
        weights.push_back(glsl_number(octave.weight, GlslReal::float32));
        frequencies.push_back(number(octave.frequency));
    }
    const std::string noise = fmt::format("{}({}, cells_of(at, 0), places_of(at, 0))",
                                          octave_noise(sum.noise), seed_of_octave(sum.octaves));
    return loop(
        weights.size(),
        fmt::format(
            "{{\n        SplitPoint at = split_points({}, lattice_limit);\n        {}    }}\n",
            scaled_point(inputs, of_octave("real", frequencies)),
            sum_line(total, of_octave("float", weights), shaped(sum.shape, noise))));
}

GlslStep GlslSteps::split_sum(const NoiseSum& sum, const Inputs& inputs) {
    const std::string total = fmt::format("n{}", values_);
    std::string lines = fmt::format("    exact float {} = 0.0;\n", total);
    const std::vector<OctaveRun> runs = octave_runs(sum.octaves);
    const bool apart = runs.size() > 2 && runs.size() == sum.octaves.size();
    if (apart) lines += apart_lines(sum, inputs, total);
    for (std::size_t g = apart ? 0 : runs.size(); g-- > 0;)
        lines += doubling_lines(
            sum, std::span(sum.octaves).subspan(runs[g].begin, runs[g].end - runs[g].begin), inputs,
            total);
    GlslStep written = value(
        sum.offset == 0.0 ? fmt::format("real({})", total)
                          : fmt::format("real({}) + {}", total, glsl_operand(number(sum.offset))));
    written.lines.insert(0, lines);
    return written;
}

GlslStep GlslSteps::site_sum(const NoiseSum& sum, const Inputs& inputs) {
    std::vector<std::string> weights, frequencies;
    for (const SumOctave& octave : sum.octaves) {
        weights.push_back(number(octave.weight));
        frequencies.push_back(number(octave.frequency));
    }
    const bool as_it_is = sum.octaves.size() == 1 && sum.octaves[0].frequency == 1.0;
    const std::string point = scaled_point(inputs, as_it_is ? "" : of_octave("real", frequencies));
    const std::string noise =
        fmt::format("{}({}, {}, {})", octave_noise(sum.noise), seed_of_octave(sum.octaves), point,
                    number(sum.noise.time.value_or(0.0)));
    GlslStep written = value(number(sum.offset));
    written.lines +=
        loop(sum.octaves.size(), sum_line(written.outputs[0], of_octave("real", weights),
                                          fmt::format("real({})", shaped(sum.shape, noise))));
    return written;
}

}  // namespace burl
