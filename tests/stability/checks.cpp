#include "tests/stability/checks.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/lattice_check.h"
#include "app/recipe/parameters.h"
#include "atlas/base/error.h"
#include "procedural/fill/synthesize.h"

namespace burl {

namespace {

StabilityRow failures(const char* group) {
    StabilityRow row;
    row.group = group;
    return row;
}

/// Returns f along lines of texels; empty where the way does not support the texture.
std::vector<double> lines_by(const StabilityWay& way, const Texture& texture,
                             const std::vector<TexelLine>& lines, int threads = 1) {
    if (!can_fill(way, texture)) return {};
    return fill_texels({"", texture, atlas_of_lines(lines)}, way, threads);
}

/// Returns lines whose texels are multiples of 2^-6 and remain exact in float64 after every move.
std::vector<TexelLine> exact_lines(const Vec3d& move) {
    std::vector<TexelLine> lines;
    for (int i = 0; i < 40; ++i)
        lines.push_back({move + Vec3d(i * 7, -i * 5, i * 3) * 0x1p-6,
                         Vec3d(1 + i % 3, -2, i % 5) * 0x1p-6, 40});
    return lines;
}

/// Returns lines of various lengths, so that batches end anywhere in them.
std::vector<TexelLine> uneven_lines(std::uint32_t before) {
    std::vector<TexelLine> lines;
    if (before > 0) lines.push_back({Vec3d(0.0), Vec3d(0.01), before});
    for (std::uint32_t i = 0; i < 48; ++i)
        lines.push_back(
            {Vec3d(0.1 * i, -3.3, 1e3 + i), Vec3d(0.013, 0.0031 * i, -0.02), 1 + i * 37 % 300});
    return lines;
}

/// Whether the recipe is refused as a usage error, in one line.
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
    plain_texture(recipe.texture)->noise = {term};
    try {
        check_lattice(recipe, Box3{Vec3d(-scale), Vec3d(scale)});
    } catch (const Error& error) {
        return error.code() == ExitCode::unsupported;
    }
    return false;
}

}  // namespace

StabilityRow check_wrap(StabilityChoice choice) {
    StabilityRow row = failures("2^32 cells apart");
    for (const NamedTerm& noise : terms_for(choice)) {
        // A simplex lattice is skewed by a third of the coordinates' sum: along an axis it repeats
        // after 3 x 2^32 cells.
        if (noise.term.kind == NoiseKind::white) continue;
        const double period = noise.term.kind == NoiseKind::simplex ? 3.0 * 0x1p32 : 0x1p32;
        for (const StabilityWay& way : stability_ways())
            for (const double move : {1.0, -1.0, 3.0, -1024.0})
                for (int axis = 0; axis < 3; ++axis, ++row.cases) {
                    Vec3d far(0.0);
                    far[axis] = move * period;
                    const Texture texture = texture_of(noise.term);
                    const auto here = lines_by(way, texture, exact_lines(Vec3d(0.0))),
                               there = lines_by(way, texture, exact_lines(far));
                    for (std::size_t i = 0; i < here.size(); ++i)
                        row.count(here[i] != there[i], [&] {
                            return fmt::format("{}, {}, axis {}, {} times 2^32, texel {}",
                                               noise.name, way.name, axis, move, i);
                        });
                }
    }
    return row;
}

StabilityRow check_threads(StabilityChoice choice) {
    StabilityRow row = failures("threads");
    const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 8);
    for (const NamedTerm& noise : terms_for(choice)) {
        const Texture texture = texture_of(noise.term);
        for (const StabilityWay& way : stability_ways()) {
            const std::vector<double> one = lines_by(way, texture, uneven_lines(0));
            for (const int threads : {2, 3, 7, 0}) {
                ++row.cases;
                const std::vector<double> many = lines_by(way, texture, uneven_lines(0), threads);
                for (std::size_t i = 0; i < one.size(); ++i)
                    row.count(one[i] != many[i], [&] {
                        return fmt::format("{}, {}, {} threads, texel {}", noise.name, way.name,
                                           threads, i);
                    });
            }
        }
    }
    return row;
}

StabilityRow check_batches(StabilityChoice choice) {
    StabilityRow row = failures("places in a batch");
    for (const NamedTerm& noise : terms_for(choice)) {
        const Texture texture = texture_of(noise.term);
        for (const StabilityWay& way : stability_ways()) {
            if (way.arithmetic != "float32") continue;  // only the kernels work in batches
            const std::vector<double> alone = lines_by(way, texture, uneven_lines(0));
            for (const std::uint32_t before : {1u, 2u, 7u, 8u, 15u, 16u, 17u, 255u}) {
                ++row.cases;
                const std::vector<double> moved = lines_by(way, texture, uneven_lines(before));
                for (std::size_t i = 0; i < alone.size(); ++i)
                    row.count(alone[i] != moved[before + i], [&] {
                        return fmt::format("{}, {}, {} texels before, texel {}", noise.name,
                                           way.name, before, i);
                    });
            }
        }
    }
    return row;
}

StabilityRow check_filters(const std::vector<StabilityGroup>& groups) {
    using enum FilterKind;
    StabilityRow row = failures("filters: finite, in [0, 1]");
    for (const StabilityGroup& group : groups)
        for (std::size_t i = 0; i < group.cases.size(); i += 1 + group.cases.size() / 12) {
            StabilityCase one = group.cases[i];
            if (one.solid.size > 1100) continue;
            for (TexelMap& map : one.solid.maps)
                map.step_y = {-map.step_x.y, map.step_x.z, map.step_x.x};
            ++row.cases;
            for (const FilterKind kind : {none, table_mip, table_sat, table_sat3, exact, trapezoid,
                                          trapezoid2, supersample})
                for (const bool band_limit : {false, true}) {
                    const Image<RgbF> image = synthesize_model<RgbF>(
                        one.solid, one.texture, one.map, 1, {kind, 4, band_limit});
                    for_each_span(
                        one.solid, [&](const Span& span, const TexelMap&, std::int64_t y) {
                            for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                                const RgbF c = image(x, std::size_t(y));
                                row.count(!(std::min({c.r, c.g, c.b}) >= -1e-6f &&
                                            std::max({c.r, c.g, c.b}) <= 1.0f + 1e-6f),
                                          [&] {
                                              return fmt::format("{}, filter {}: {}", one.input,
                                                                 int(kind), c.r);
                                          });
                            }
                        });
                }
        }
    return row;
}

StabilityRow check_refusals() {
    StabilityRow row = failures("refusals");
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
            row.count(!is_refused(setting), [&] { return setting + " is accepted"; });
        }
    }
    // The limit is 2^46 cells at the last octave's frequency; the next float is beyond it.
    const double limit = farthest_cell, over = std::nextafter(limit, HUGE_VAL);
    row.count(octaves_are_refused(2.0, 1, limit),
              [&] { return std::string("2^46 cells are refused"); });
    row.count(!octaves_are_refused(2.0, 1, over),
              [&] { return std::string("more than 2^46 cells are accepted"); });
    row.count(octaves_are_refused(2.0, 24, limit / 0x1p23),
              [&] { return std::string("octave 24 at 2^46 is refused"); });
    row.count(!octaves_are_refused(2.0, 24, over / 0x1p23),
              [&] { return std::string("octave 24 beyond 2^46 is accepted"); });
    row.count(!octaves_are_refused(16.0, 24, 1.0),
              [&] { return std::string("16^23 cells are accepted"); });
    for (const double scale : {1e300, HUGE_VAL, std::nan("")})
        row.count(!octaves_are_refused(2.0, 1, scale),
                  [&] { return fmt::format("{} cells are accepted", scale); });
    ++row.cases;
    return row;
}

}  // namespace burl
