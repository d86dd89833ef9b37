#include "app/stability_checks.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include "app/lattice_check.h"
#include "app/parameters.h"
#include "atlas/error.h"
#include "procedural/synthesize.h"

namespace burl {

namespace {

/// `input` is called for the first failure only.
template <class Input>
void count(StabilityRow& row, bool fails, const Input& input) {
    ++row.values;
    if (!fails) return;
    row.share += 1.0, row.error += 1.0;
    if (row.input.empty()) row.input = input();
}

Texture four_octaves(NoiseKind kind) {
    Texture texture;
    NoiseTerm term;
    term.kind = kind, term.octaves = 4;
    texture.noise = {term};
    texture.colors.stops = {{0.0, {0, 0, 0}}, {1.0, {255, 255, 255}}};
    return texture;
}

/// Lines whose texels are multiples of 2^-6, exact in float64 wherever they are moved to.
std::vector<TexelLine> exact_lines(const Vec3d& move) {
    std::vector<TexelLine> lines;
    for (int i = 0; i < 40; ++i)
        lines.push_back({move + Vec3d(i * 7, -i * 5, i * 3) * 0x1p-6,
                         Vec3d(1 + i % 3, -2, i % 5) * 0x1p-6, 40});
    return lines;
}

/// Lines of several lengths, so that batches end anywhere in them.
std::vector<TexelLine> uneven_lines(std::uint32_t before) {
    std::vector<TexelLine> lines;
    if (before > 0) lines.push_back({Vec3d(0.0), Vec3d(0.01), before});
    for (std::uint32_t i = 0; i < 48; ++i)
        lines.push_back(
            {Vec3d(0.1 * i, -3.3, 1e3 + i), Vec3d(0.013, 0.0031 * i, -0.02), 1 + i * 37 % 300});
    return lines;
}

}  // namespace

StabilityRow check_wrap() {
    StabilityRow row{"2^32 cells apart"};
    for (const NoiseKind kind : {NoiseKind::value, NoiseKind::perlin})
        for (const double move : {1.0, -1.0, 3.0, -1024.0})
            for (int axis = 0; axis < 3; ++axis, ++row.cases) {
                Vec3d far(0.0);
                far[axis] = move * 0x1p32;
                const auto field = [&](const Vec3d& moved) {
                    return synthesize_field(atlas_of_lines(exact_lines(moved)), four_octaves(kind),
                                            {}, 1);
                };
                const Image<float> here = field(Vec3d(0.0)), there = field(far);
                for (std::size_t i = 0; i < here.pixels().size(); ++i)
                    count(row, here.pixels()[i] != there.pixels()[i], [&] {
                        return fmt::format("kind {}, axis {}, {} times 2^32, texel {}", int(kind),
                                           axis, move, i);
                    });
            }
    return row;
}

StabilityRow check_threads() {
    StabilityRow row{"threads"};
    const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 8);
    const SolidAtlas solid = atlas_of_lines(uneven_lines(0));
    for (const NoiseKind kind : {NoiseKind::value, NoiseKind::perlin, NoiseKind::simplex}) {
        const Texture texture = four_octaves(kind);
        const Image<float> one = synthesize_field(solid, texture, {}, 1);
        for (const int threads : {2, 3, 7, 0}) {
            ++row.cases;
            const Image<float> many = synthesize_field(solid, texture, {}, threads);
            for (std::size_t i = 0; i < one.pixels().size(); ++i)
                count(row, one.pixels()[i] != many.pixels()[i], [&] {
                    return fmt::format("kind {}, {} threads, texel {}", int(kind), threads, i);
                });
        }
    }
    return row;
}

StabilityRow check_batches() {
    StabilityRow row{"places in a batch"};
    for (const NoiseKind kind : {NoiseKind::value, NoiseKind::perlin}) {
        const Texture texture = four_octaves(kind);
        const SolidAtlas alone = atlas_of_lines(uneven_lines(0));
        const Image<float> one = synthesize_field(alone, texture, {}, 1);
        for (const std::uint32_t before : {1u, 2u, 7u, 8u, 15u, 16u, 17u, 255u}) {
            ++row.cases;
            const Image<float> moved =
                synthesize_field(atlas_of_lines(uneven_lines(before)), texture, {}, 1);
            for (std::size_t y = 0; y < 48; ++y)
                for (std::size_t x = 0; x < alone.row(y)[0].count; ++x)
                    count(row, one(x, y) != moved(x, y + 1), [&] {
                        return fmt::format("kind {}, {} texels before, texel ({}, {})", int(kind),
                                           before, x, y);
                    });
        }
    }
    return row;
}

StabilityRow check_filters(const std::vector<StabilityGroup>& groups) {
    using enum FilterKind;
    StabilityRow row{"filters: finite, in [0, 1]"};
    for (const StabilityGroup& group : groups)
        for (std::size_t i = 0; i < group.cases.size(); i += 1 + group.cases.size() / 12) {
            StabilityCase one = group.cases[i];
            if (one.solid.size > 2048) continue;
            for (TexelMap& map : one.solid.maps)
                map.step_y = {-map.step_x.y, map.step_x.z, map.step_x.x};
            ++row.cases;
            for (const FilterKind kind : {none, table_mip, table_sat, table_sat3, exact, trapezoid,
                                          trapezoid2, supersample})
                for (const bool band_limit : {false, true}) {
                    const Image<RgbF> image =
                        synthesize_rgbf(one.solid, one.texture, one.map, 1, {kind, 4, band_limit});
                    for (const RgbF& c : image.pixels())
                        count(row,
                              !(std::min({c.r, c.g, c.b}) >= -1e-6f &&
                                std::max({c.r, c.g, c.b}) <= 1.0f + 1e-6f),
                              [&] {
                                  return fmt::format("{}, filter {}: {}", one.input, int(kind),
                                                     c.r);
                              });
                }
        }
    return row;
}

namespace {

/// Whether the recipe is refused, in one line.
bool is_refused(const std::string& setting) {
    const std::string base =
        R"({"texture": {"stops": [[0, "#000000"]], "input": {"noise": [{}]}}})";
    try {
        parse_recipe(base, "base", {setting});
    } catch (const Error& error) {
        return error.code() == ExitCode::usage &&
               std::string(error.what()).find('\n') == std::string::npos;
    }
    return false;
}

std::string repeated(const std::string& word, std::size_t count) {
    return fmt::format("[{}]", fmt::join(std::vector<std::string>(count, word), ","));
}

bool octaves_are_refused(double lacunarity, int octaves, double scale) {
    Recipe recipe;
    NoiseTerm term;
    term.lacunarity = lacunarity, term.octaves = std::uint32_t(octaves), term.gain = 1.0;
    recipe.texture.noise = {term};
    try {
        check_lattice(recipe, Box3{Vec3d(-scale), Vec3d(scale)});
    } catch (const Error& error) {
        return error.code() == ExitCode::unsupported;
    }
    return false;
}

}  // namespace

StabilityRow check_refusals() {
    StabilityRow row{"refusals"};
    for (const Parameter& parameter : parameters()) {
        const bool several = parameter.type == ParameterType::numbers;
        if (parameter.type != ParameterType::number && parameter.type != ParameterType::integer &&
            !several)
            continue;
        std::string path(parameter.path);
        std::replace(path.begin(), path.end(), '*', '0');
        ++row.cases;
        for (const std::string word :
             {"nan", "NaN", "-nan", "inf", "Infinity", "-Infinity", "1e999", "-1e999", "1e400",
              "null", "true", "\"1\"", "1e300", "-1e300"}) {
            const std::string setting =
                fmt::format("{}={}", path, several ? repeated(word, parameter.count) : word);
            count(row, !is_refused(setting), [&] { return setting + " is accepted"; });
        }
    }
    // 2^46 cells at the last octave's own frequency, and a float more.
    const double limit = farthest_cell, over = std::nextafter(limit, HUGE_VAL);
    count(row, octaves_are_refused(2.0, 1, limit),
          [&] { return std::string("2^46 cells are refused"); });
    count(row, !octaves_are_refused(2.0, 1, over),
          [&] { return std::string("more than 2^46 cells are accepted"); });
    count(row, octaves_are_refused(2.0, 24, limit / 0x1p23),
          [&] { return std::string("octave 24 at 2^46 is refused"); });
    count(row, !octaves_are_refused(2.0, 24, over / 0x1p23),
          [&] { return std::string("octave 24 beyond 2^46 is accepted"); });
    count(row, !octaves_are_refused(16.0, 24, 1.0),
          [&] { return std::string("16^23 cells are accepted"); });
    for (const double scale : {1e300, HUGE_VAL, std::nan("")})
        count(row, !octaves_are_refused(2.0, 1, scale),
              [&] { return fmt::format("{} cells are accepted", scale); });
    ++row.cases;
    return row;
}

}  // namespace burl
