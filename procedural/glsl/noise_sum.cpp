#include "procedural/glsl/noise_sum.h"

#include <algorithm>

#include <fmt/format.h>

namespace burl {

namespace {

/// The text "real3(x, y, z)" of a point, times the frequency if there is one.
std::string scaled_point(const GlslNoiseSums::Point& point, const std::string& frequency) {
    const std::string text = point == GlslNoiseSums::Point{"solid.x", "solid.y", "solid.z"}
                                 ? "solid"
                                 : fmt::format("real3({}, {}, {})", point[0], point[1], point[2]);
    return frequency.empty() ? text : fmt::format("{} * {}", frequency, text);
}

/// A loop over the octaves, from the finest, whose amplitude is the least, to the coarsest, or
/// `ascending` from the coarsest; the line alone for one octave.
std::string loop(std::size_t octaves, const std::string& line, bool ascending = false) {
    if (octaves == 1) return "    " + line;
    const std::string head = ascending ? fmt::format("for (int k = 0; k < {}; ++k)", octaves)
                                       : fmt::format("for (int k = {}; k >= 0; --k)", octaves - 1);
    return fmt::format("    {}{}{}", head, line.starts_with('{') ? " " : "\n        ", line);
}

std::string weighed(const std::string& weight, const std::string& octave) {
    const bool one = weight == "1.0" || weight == "1.0lf";
    return one ? octave : weight + " * " + octave;
}

std::string float_number(double x) {
    return glsl_number(x, GlslReal::float32);
}

/// The texts number(octave) of all octaves.
template <class Number>
std::vector<std::string> of_each(std::span<const SumOctave> octaves, const Number& number) {
    std::vector<std::string> texts;
    for (const SumOctave& octave : octaves) texts.push_back(number(octave));
    return texts;
}

/// A number of all octaves.
std::vector<double> all_of(std::span<const SumOctave> octaves, double SumOctave::*number) {
    std::vector<double> numbers;
    for (const SumOctave& octave : octaves) numbers.push_back(octave.*number);
    return numbers;
}

}  // namespace

/// Some octaves of a sum, and the way in which their noise becomes part of it.
struct GlslNoiseSums::Octaves {
    const NoiseSum& sum;
    std::span<const SumOctave> octaves;
    std::size_t first = 0;  ///< number of the first octave in the sum
    bool sloped = false;
    std::string kept{};  ///< name of the number of octaves that show, for sums with gradients
    double mean = 0.0;

    Octaves part(const OctaveRun& run) const {
        return {sum, octaves.subspan(run.begin, run.end - run.begin), run.begin, sloped, kept,
                mean};
    }
    /// The expression of octave k's number in the sum.
    std::string number() const {
        const char* k = octaves.size() > 1 ? "k" : "0";
        return first == 0 ? k : fmt::format("{} + {}", first, k);
    }
};

/// The line "total = total + weight * shape(octave);" of octave k of a run.
std::string GlslNoiseSums::sum_line(const Octaves& all, const std::string& split,
                                    const std::string& total) {
    const bool several = all.octaves.size() > 1;
    const bool doubling = several && split != "at";
    const char* k = doubling ? "k" : "0";
    const std::string noise = fmt::format("{0}({1}, cells_of({2}, {3}), places_of({2}, {3}))",
                                          functions_.octave(all.sum.noise, all.sloped),
                                          functions_.seed_of_octave(all.octaves), split, k);
    const std::string weight = functions_.of_octave(
        "float", of_each(all.octaves, [](const auto& o) { return float_number(o.weight); }));
    if (!all.sloped)
        return fmt::format("{0} = {0} + {1};\n", total,
                           weighed(weight, functions_.shaped(all.sum.shape, noise)));
    const std::string steepness = functions_.of_octave(
        "float",
        of_each(all.octaves, [](const auto& o) { return float_number(o.weight * o.frequency); }));
    const std::string share =
        all.kept.empty() ? "1.0"
                         : fmt::format("visible_share({}, float({}))", all.kept, all.number());
    return fmt::format("{0} = {0} + {1}_octave({2}, {3}, {4}, {5}, {6});\n", total,
                       glsl_shape_name(all.sum.shape), noise, weight, steepness, share,
                       float_number(all.kept.empty() ? 0.0 : all.mean));
}

/// The lines of octaves that double one another, from one split point.
std::string GlslNoiseSums::doubling_lines(const Octaves& octaves, const Point& point,
                                          const std::string& total) {
    const double frequency = octaves.octaves[0].frequency;
    const std::string at =
        scaled_point(point, frequency == 1.0 ? "" : functions_.number(frequency));
    const auto [split, is_new] = splits_.try_emplace(at, fmt::format("at{}", splits_.size()));
    std::string lines;
    if (is_new)
        lines = fmt::format("    SplitPoint {} = split_points({}, lattice_limit);\n", split->second,
                            at);
    return lines + loop(octaves.octaves.size(), sum_line(octaves, split->second, total));
}

/// The lines of octaves in a loop, each from a split point of its own.
std::string GlslNoiseSums::apart_lines(const Octaves& all, const Point& point,
                                       const std::string& total) {
    const std::string frequency =
        functions_.real_of_octave(all_of(all.octaves, &SumOctave::frequency));
    return loop(
        all.octaves.size(),
        fmt::format(
            "{{\n        SplitPoint at = split_points({}, lattice_limit);\n        {}    }}\n",
            scaled_point(point, frequency), sum_line(all, "at", total)));
}

std::string GlslNoiseSums::split_lines(const Octaves& all, const Point& point,
                                       const std::string& total) {
    const std::vector<OctaveRun> runs = octave_runs(all.octaves);
    if (runs.size() > 2 && runs.size() == all.octaves.size()) return apart_lines(all, point, total);
    std::string lines;
    for (std::size_t g = runs.size(); g-- > 0;)
        lines += doubling_lines(all.part(runs[g]), point, total);
    return lines;
}

/// The expression of octave k at a site of its own.
std::string GlslNoiseSums::site_noise(const NoiseSum& sum, const Point& point, bool sloped) {
    const bool as_it_is = sum.octaves.size() == 1 && sum.octaves[0].frequency == 1.0;
    const std::string frequency =
        as_it_is ? "" : functions_.real_of_octave(all_of(sum.octaves, &SumOctave::frequency));
    return fmt::format("{}({}, {}, {})", functions_.octave(sum.noise, sloped),
                       functions_.seed_of_octave(sum.octaves), scaled_point(point, frequency),
                       functions_.number(sum.noise.time.value_or(0.0)));
}

GlslSum GlslNoiseSums::values(const NoiseSum& sum, const Point& point, const std::string& total) {
    if (has_point_kernel(sum.noise)) {
        const std::string lines = split_lines({sum, sum.octaves}, point, total);
        const std::string offset =
            sum.offset == 0.0 ? ""
                              : fmt::format(" + {}", glsl_operand(functions_.number(sum.offset)));
        return {fmt::format("    exact float {} = 0.0;\n{}", total, lines),
                fmt::format("real({}){}", total, offset)};
    }
    const std::string weight = functions_.real_of_octave(all_of(sum.octaves, &SumOctave::weight));
    const std::string octave =
        fmt::format("real({})", functions_.shaped(sum.shape, site_noise(sum, point, false)));
    return {fmt::format("    exact real {} = {};\n", total, functions_.number(sum.offset)) +
                loop(sum.octaves.size(),
                     fmt::format("{0} = {0} + {1};\n", total, weighed(weight, octave))),
            total};
}

GlslSum GlslNoiseSums::slopes(const NoiseSum& sum, const Point& point, const std::string& kept,
                              double mean, const std::string& total) {
    const Octaves all{sum, sum.octaves, 0, true, kept, mean};
    if (has_point_kernel(sum.noise)) {
        const std::string lines = split_lines(all, point, total);
        return {fmt::format("    exact vec4 {} = vec4(0.0);\n{}", total, lines), total};
    }
    const auto number = [&](double x) { return functions_.number(x); };
    const std::string weight = functions_.real_of_octave(all_of(sum.octaves, &SumOctave::weight));
    const std::string frequency =
        functions_.real_of_octave(all_of(sum.octaves, &SumOctave::frequency));
    const std::string share =
        kept.empty() ? number(1.0) : fmt::format("visible_part({}, real({}))", kept, all.number());
    const std::string line =
        fmt::format("{0} = add_octave({0}, {1}_sample({2}), {3}, {4}, {5}, {6});\n", total,
                    glsl_shape_name(sum.shape), site_noise(sum, point, true), weight, frequency,
                    share, number(kept.empty() ? 0.0 : mean));
    return {
        fmt::format("    real4 {} = real4(0.0);\n", total) + loop(sum.octaves.size(), line, true),
        fmt::format("vec4({})", total)};
}

}  // namespace burl
