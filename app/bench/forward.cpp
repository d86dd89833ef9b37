#include "app/bench/forward.h"

#include <cmath>
#include <iterator>
#include <memory>
#include <random>

#include <fmt/format.h>

#include "app/bench/bench.h"
#include "app/bench/command.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/recipe.h"
#include "atlas/base/json.h"
#include "procedural/bresenham/field.h"
#include "procedural/color/table.h"
#include "procedural/field/sampler.h"
#include "procedural/noise/names.h"
#include "procedural/noise/noise.h"

namespace burl {

namespace {

/// A method of evaluating f along lines; values() evaluates one line of at most batch_capacity
/// texels.
struct Method {
    std::string name;
    std::function<ForwardCounts(const LatticeLine&, double*)> values;
};

/// Evaluates as a bake does: vectorised, in float32 with sums in float64.
Method kernel_method(const Texture& texture, Kernel kernel, const char* name) {
    const auto sampler = std::make_shared<FieldSampler>(texture, false, kernel);
    const auto batch = std::make_shared<FieldBatch>();
    return {name, [=](const LatticeLine& line, double* f) {
                batch->pieces.assign(1, Piece{0, 0, line, {}});
                batch->count = line.count;
                sampler->values(*batch);
                std::copy_n(batch->field, line.count, f);
                return ForwardCounts{};
            }};
}

/// Evaluates texel by texel in float64, the paper's baseline.
Method texelwise_method(const Texture& texture) {
    return {"texel by texel, float64",
            [&texture, octaves = expand_octaves(texture)](const LatticeLine& line, double* f) {
                for (std::size_t j = 0; j < line.count; ++j)
                    f[j] = evaluate_field(texture.quadric, octaves,
                                          line.start + (line.first + double(j)) * line.step);
                return ForwardCounts{};
            }};
}

Method forward_method(const Texture& texture, const std::string& name, ForwardPrecision precision) {
    return {"forward, " + name, [&texture, precision, octaves = expand_octaves(texture)](
                                    const LatticeLine& line, double* f) {
                return forward_field(texture.quadric, octaves, line, {precision, 0}, f);
            }};
}

/// Evaluates the quadric and every octave by forward differences of their own.
Method octaves_method(const Texture& texture) {
    return {"forward, octave by octave",
            [&texture, octaves = expand_octaves(texture)](const LatticeLine& line, double* f) {
                return forward_octaves(texture.quadric, octaves, line, {}, f);
            }};
}

std::vector<Method> methods(const Texture& texture) {
    std::vector<Method> list{texelwise_method(texture),
                             kernel_method(texture, Kernel::direct, "kernel direct"),
                             kernel_method(texture, Kernel::automatic, "kernel auto"),
                             forward_method(texture, "float32", ForwardPrecision::float32),
                             forward_method(texture, "float64", ForwardPrecision::float64),
                             forward_method(texture, "fixed64", ForwardPrecision::fixed64)};
    if (expand_octaves(texture).size() > 1) list.push_back(octaves_method(texture));
    return list;
}

struct Measured {
    double error = 0.0;
    ForwardCounts counts;
};

Measured measure(const Method& method, const Method& exact, const std::vector<LatticeLine>& lines) {
    Measured result;
    std::vector<double> f(batch_capacity), truth(batch_capacity);
    for (const LatticeLine& line : lines) {
        result.counts += method.values(line, f.data());
        exact.values(line, truth.data());
        for (std::size_t j = 0; j < line.count; ++j)
            result.error = std::max(result.error, std::abs(f[j] - truth[j]));
    }
    return result;
}

/// Times the methods over all lines, in paired rounds.
std::vector<BenchRow> time_rows(const std::vector<Method>& list,
                                const std::vector<LatticeLine>& lines, int repeats) {
    std::vector<BenchCase> cases;
    double texels = 0.0;
    for (const LatticeLine& line : lines) texels += double(line.count);
    const auto f = std::make_shared<std::vector<double>>(batch_capacity);
    for (const Method& method : list)
        cases.push_back({method.name, texels, "texel", [=, &lines] {
                             for (const LatticeLine& line : lines) method.values(line, f->data());
                         }});
    return run_paired(cases, repeats);
}

Texture bench_texture(Fade fade, std::uint32_t octaves) {
    NoiseTerm term;
    term.fade = fade;
    term.octaves = octaves;
    Texture texture;
    texture.noise = {term};
    if (octaves > 1) texture.quadric.i = 0.5;
    return texture;
}

std::vector<LatticeLine> random_lines(double step) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&] {
        const double x = unit(random), y = unit(random), z = unit(random);
        return Vec3d(x, y, z);
    };
    std::vector<LatticeLine> lines;
    for (int i = 0; i < 16; ++i) {
        const Vec3d direction = glm::normalize(vector());
        lines.push_back({10.0 * vector(), step * direction, 0.0, batch_capacity});
    }
    return lines;
}

/// Returns scan lines of the faces of the cube [0, size]^3 that meet at (size, size, size).
std::vector<LatticeLine> cube_lines(double size, std::size_t side) {
    std::vector<LatticeLine> lines;
    const double step = size / double(side);
    for (int axis = 0; axis < 3; ++axis)
        for (std::size_t y = 0; y < side; ++y) {
            LatticeLine line;
            line.start[axis] = size;
            line.start[(axis + 1) % 3] = 0.5 * step;
            line.start[(axis + 2) % 3] = (double(y) + 0.5) * step;
            line.step[(axis + 1) % 3] = step;
            line.count = side;
            lines.push_back(line);
        }
    return lines;
}

/// Measures every method at every step; the rows of a method are adjacent.
std::vector<ForwardBench> bench_function(const std::string& name, const Texture& texture,
                                         int repeats) {
    constexpr int powers[] = {12, 10, 8, 6, 5, 4, 3, 2, 0};
    const std::vector<Method> list = methods(texture);
    std::vector<ForwardBench> rows(list.size() * std::size(powers));
    for (std::size_t i = 0; i < std::size(powers); ++i) {
        const double step = std::ldexp(1.0, -powers[i]);
        const std::vector<LatticeLine> lines = random_lines(step);
        const std::vector<BenchRow> times = time_rows(list, lines, repeats);
        for (std::size_t k = 0; k < list.size(); ++k) {
            const auto [error, counts] = measure(list[k], list[0], lines);
            rows[k * std::size(powers) + i] = {name,
                                               list[k].name,
                                               step,
                                               times[k].ns_per_unit(),
                                               error,
                                               double(counts.cells) / times[k].units,
                                               double(counts.runs) / times[k].units};
        }
    }
    return rows;
}

/// Counts the texels whose 8-bit colours differ between two methods.
void count_codes(const Method& method, const Method& exact, const ColorMap& colors,
                 const std::vector<LatticeLine>& lines, CubeBench& row) {
    const ColorTable8 color(colors);
    std::vector<double> f(batch_capacity), truth(batch_capacity);
    for (const LatticeLine& line : lines) {
        method.values(line, f.data());
        exact.values(line, truth.data());
        for (std::size_t j = 0; j < line.count; ++j) {
            const Rgb8 a = color(f[j]), b = color(truth[j]);
            row.other_codes += a != b;
            row.largest_step = std::max(
                {row.largest_step, std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
        }
    }
}

GrowthBench growth(Fade fade, double frequency, ForwardPrecision precision, const char* in) {
    const double step = 2.0 * frequency / 256.0;
    GrowthBench bench{std::string(to_string(fade)), in, frequency, {}};
    for (std::size_t texel = 0; double(texel) < 1.0 / step; texel = texel == 0 ? 1 : 2 * texel)
        bench.errors.push_back({texel, 0.0});
    bench.errors.push_back({std::size_t(1.0 / step) - 1, 0.0});
    const LatticeLine line{{}, Vec3d(step), 0.0, 256};
    for (std::uint32_t seed = 0; seed < 64; ++seed) {
        const NoiseSpec noise{.fade = fade, .seed = seed};
        std::vector<double> n(line.count, 0.0);
        add_forward_noise(noise, 1.0, line, {precision, std::int64_t(1) << 62}, n.data());
        for (auto& [texel, largest] : bench.errors)
            for (double j = double(texel); j < 256.0; j += 1.0 / step)
                largest = std::max(
                    largest, std::abs(n[std::size_t(j)] - evaluate_noise(noise, j * line.step)));
    }
    return bench;
}

Json forward_json(const ForwardBench& row) {
    return {{"function", row.function},
            {"method", row.method},
            {"step_cells", row.step},
            {"ns_per_texel", row.ns_per_texel},
            {"error", row.error},
            {"cells_per_texel", row.cells_per_texel},
            {"runs_per_texel", row.runs_per_texel}};
}

Json cube_json(const CubeBench& row) {
    return {{"texture", row.texture},
            {"method", row.method},
            {"milliseconds", row.milliseconds},
            {"error", row.error},
            {"texels_with_other_codes", row.other_codes},
            {"largest_code_step", row.largest_step},
            {"cells", row.cells},
            {"runs", row.runs}};
}

Json growth_json(const GrowthBench& row) {
    Json errors = Json::array();
    for (const auto& [texel, largest] : row.errors)
        errors.push_back({{"texel_of_cell", texel}, {"error", largest}});
    return {{"noise", row.noise},
            {"frequency", row.frequency},
            {"precision", row.precision},
            {"errors", errors}};
}

/// Prints a table per function, with a line per method and a column cell(row) per step.
template <class Cell>
void print_steps(const std::vector<ForwardBench>& rows, const char* what, Cell&& cell) {
    std::string function, method;
    for (const ForwardBench& row : rows) {
        if (row.function != function) {
            fmt::print("\n{}: {}, by cells per texel\n{:<26}", row.function, what, "");
            for (const ForwardBench& one : rows)
                if (one.function == row.function && one.method == row.method)
                    fmt::print(" {:>8}", fmt::format("1/{:.0f}", 1.0 / one.step));
            method.clear();
        }
        if (row.method != method) fmt::print("\n{:<26}", row.method);
        fmt::print(" {:>8}", cell(row));
        function = row.function;
        method = row.method;
        if (&row == &rows.back() || (&row)[1].function != function) fmt::print("\n");
    }
}

void print_cubes(const std::vector<CubeBench>& rows) {
    fmt::print("\n{:<16} {:<26} {:>9} {:>9} {:>12} {:>5} {:>8} {:>8}\n", "three faces", "method",
               "ms", "error", "other codes", "by", "cells", "runs");
    for (const CubeBench& row : rows)
        fmt::print("{:<16} {:<26} {:>9.3f} {:>9.1e} {:>12} {:>5} {:>8} {:>8}\n", row.texture,
                   row.method, row.milliseconds, row.error, row.other_codes, row.largest_step,
                   row.cells, row.runs);
}

/// Prints the largest errors by the index of the texel in its cell.
void print_growth(const std::vector<GrowthBench>& rows) {
    double frequency = 0.0;
    for (const GrowthBench& row : rows) {
        if (row.frequency != frequency) {
            fmt::print("\n{:<18}", fmt::format("frequency {:g}, texel", row.frequency));
            for (const auto& error : row.errors) fmt::print(" {:>8}", error.texel);
            fmt::print("\n");
        }
        frequency = row.frequency;
        fmt::print("{:<8} {:<9}  ", row.noise, row.precision);
        for (const auto& error : row.errors) fmt::print(" {:>8.1e}", error.largest);
        fmt::print("\n");
    }
}

}  // namespace

std::vector<ForwardBench> bench_forward(int repeats) {
    std::vector<ForwardBench> rows;
    for (const std::uint32_t octaves : {1u, 4u})
        for (const Fade fade : {Fade::linear, Fade::smooth, Fade::quintic}) {
            const std::string function =
                fmt::format("{}{}", octaves == 1 ? "" : "marble ", to_string(fade));
            const std::vector<ForwardBench> part =
                bench_function(function, bench_texture(fade, octaves), repeats);
            rows.insert(rows.end(), part.begin(), part.end());
        }
    return rows;
}

std::vector<GrowthBench> bench_forward_growth() {
    std::vector<GrowthBench> rows;
    for (const double frequency : {1.0, 8.0})
        for (const Fade fade : {Fade::linear, Fade::smooth, Fade::quintic})
            for (const auto& [precision, in] : {std::pair{ForwardPrecision::float32, "float32"},
                                                {ForwardPrecision::float64, "float64"},
                                                {ForwardPrecision::fixed64, "fixed64"}})
                rows.push_back(growth(fade, frequency, precision, in));
    return rows;
}

std::vector<CubeBench> bench_forward_cubes(int repeats, std::size_t side) {
    std::vector<CubeBench> rows;
    for (const auto& [name, size] : {std::pair{"bresenham-wood", 1.0}, {"bresenham-marble", 2.0}}) {
        const Texture texture = *plain_texture(load_recipe(name).texture);
        const std::vector<Method> list = methods(texture);
        const std::vector<LatticeLine> lines = cube_lines(size, side);
        const std::vector<BenchRow> times = time_rows(list, lines, repeats);
        for (std::size_t k = 0; k < list.size(); ++k) {
            const auto [error, counts] = measure(list[k], list[0], lines);
            rows.push_back({name, list[k].name, 1e3 * times[k].median, error, 0, 0, counts.cells,
                            counts.runs});
            count_codes(list[k], list[0], texture.colors, lines, rows.back());
        }
    }
    return rows;
}

void run_forward_bench(const BenchCommand& command) {
    const std::vector<ForwardBench> rows = bench_forward(command.repeats);
    const std::vector<CubeBench> cubes = bench_forward_cubes(command.repeats, command.size_or(256));
    const std::vector<GrowthBench> growth = bench_forward_growth();
    Json list = Json::array();
    for (const ForwardBench& row : rows) list.push_back(forward_json(row));
    for (const CubeBench& row : cubes) list.push_back(cube_json(row));
    for (const GrowthBench& row : growth) list.push_back(growth_json(row));
    write_report(command, list);
    if (command.json) return;
    print_steps(rows, "ns per texel",
                [](const ForwardBench& row) { return fmt::format("{:.2f}", row.ns_per_texel); });
    print_steps(rows, "largest error",
                [](const ForwardBench& row) { return fmt::format("{:.1e}", row.error); });
    print_cubes(cubes);
    print_growth(growth);
}

}  // namespace burl
