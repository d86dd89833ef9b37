#include "app/bench/precision.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "app/bench/command.h"
#include "app/bench/meshes.h"
#include "app/bench/synthesis.h"
#include "app/options/command_options.h"
#include "app/pipeline/pipeline.h"
#include "atlas/base/json.h"
#include "procedural/color/table.h"
#include "procedural/fill/synthesize.h"
#include "procedural/fill/texels.h"
#include "procedural/fixed/noise.h"
#include "procedural/model/octaves.h"

namespace burl {

namespace {

/// Returns the precisions to measure. Wood and marble of the papers stay within one unit of 0, so
/// eight integer bits suffice.
std::vector<std::string> precisions() {
    std::vector<std::string> names{"float64", "float32"};
    for (const unsigned bits : {16, 14, 12, 10, 9, 8, 7, 6, 5, 4, 3, 2})
        names.push_back(fmt::format("fixed:8.{}", bits));
    return names;
}

/// A texture at one precision: the field f, and the colours as a bake stores them.
struct Filled {
    Image<double> field;
    Image<Rgb8> colors;
};

Filled fill(Pipeline& pipeline, const Precision& precision) {
    Recipe recipe = pipeline.recipe();
    recipe.precision = precision;
    pipeline.set_recipe(recipe);
    Filled filled;
    const Texture& texture = *plain_texture(recipe.texture);
    const Affine3 map = texture_from_solid(recipe);
    if (precision.kind == PrecisionKind::float32) {
        const Image<float> field = synthesize_field(pipeline.solid(), texture, map, 0);
        filled.field = Image<double>(field.width(), field.height());
        for (std::size_t y = 0; y < field.height(); ++y)
            for (std::size_t x = 0; x < field.width(); ++x)
                filled.field(x, y) = double(field(x, y));
    } else {
        filled.field = field_of_texels(pipeline.solid(), texture, map, precision, 0);
    }
    filled.colors = pipeline.synthesize<Rgb8>();
    return filled;
}

struct Difference {
    double largest = 0.0, rms = 0.0, psnr = 0.0;
};

Difference compare(const SolidAtlas& solid, const Filled& one, const Filled& exact) {
    Difference result;
    double squares = 0.0, codes = 0.0, texels = 0.0;
    for (std::size_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::size_t x = span.x; x < span.x + span.count; ++x, texels += 1.0) {
                const double error = one.field(x, y) - exact.field(x, y);
                result.largest = std::max(result.largest, std::abs(error));
                squares += error * error;
                const Rgb8 a = one.colors(x, y), b = exact.colors(x, y);
                for (const int d : {a.r - b.r, a.g - b.g, a.b - b.b}) codes += double(d * d) / 3.0;
            }
    result.rms = std::sqrt(squares / texels);
    result.psnr = 20.0 * std::log10(255.0 / std::sqrt(codes / texels));
    return result;
}

/// Evaluates the texture in float64 at points whose coordinates are truncated to the format.
Filled fill_at_cut_points(const SolidAtlas& solid, const Recipe& recipe,
                          const FixedFormat& format) {
    const Texture& texture = *plain_texture(recipe.texture);
    const std::vector<Octave> octaves = expand_octaves(texture);
    const ColorTable8 colors(texture.colors);
    const Affine3 map = texture_from_solid(recipe);
    Filled filled{Image<double>(solid.size, solid.size), Image<Rgb8>(solid.size, solid.size)};
    for (std::size_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::size_t x = span.x; x < span.x + span.count; ++x) {
                Vec3d s = map(solid.maps[span.map](std::int64_t(x), std::int64_t(y)));
                for (int axis = 0; axis < 3; ++axis)
                    s[axis] = std::ldexp(double(fixed_coordinate(s[axis], format)),
                                         -int(format.fraction_bits));
                const double f = evaluate_field(texture.quadric, octaves, s);
                filled.field(x, y) = f;
                filled.colors(x, y) = colors(f);
            }
    return filled;
}

PrecisionBench measured(const std::string& preset, const std::string& name, Pipeline& pipeline,
                        const Filled& exact) {
    const Precision precision = parse_precision(name);
    const Difference all = compare(pipeline.solid(), fill(pipeline, precision), exact);
    PrecisionBench row{preset, name, all.largest, all.rms, all.psnr};
    if (precision.kind != PrecisionKind::fixed) return row;
    const Difference coordinates =
        compare(pipeline.solid(),
                fill_at_cut_points(pipeline.solid(), pipeline.recipe(), precision.format), exact);
    row.coordinate_rms_error = coordinates.rms, row.coordinate_psnr = coordinates.psnr;
    return row;
}

std::shared_ptr<Pipeline> torus_with(const char* preset, std::size_t side) {
    auto pipeline = std::make_shared<Pipeline>(torus(6000));
    pipeline->set_recipe(sized_recipe(preset, side));
    pipeline->solid();
    return pipeline;
}

void add_times(std::vector<PrecisionBench>& rows, const std::shared_ptr<Pipeline>& pipeline,
               std::size_t begin, int repeats) {
    const double texels = double(pipeline->solid().size) * double(pipeline->solid().size);
    std::vector<BenchCase> cases;
    for (std::size_t i = begin; i < rows.size(); ++i) {
        Recipe recipe = pipeline->recipe();
        recipe.precision = parse_precision(rows[i].precision);
        cases.push_back({rows[i].precision, texels, "texel",
                         [pipeline, recipe] {
                             pipeline->set_recipe(recipe);
                             pipeline->set_threads(1);
                             pipeline->synthesize<Rgb8>();
                         },
                         rows[i].texture});
    }
    const std::vector<BenchRow> times = run_paired(cases, repeats);
    for (std::size_t i = begin; i < rows.size(); ++i) rows[i].time = times[i - begin];
}

Json precision_json(const PrecisionBench& row) {
    Json json = result_json({row.time, BenchError{row.max_error, row.rms_error}});
    json["psnr"] = std::isfinite(row.psnr) ? Json(row.psnr) : Json();
    if (row.coordinate_rms_error > 0.0) {
        json["coordinate_rms_error"] = row.coordinate_rms_error;
        json["coordinate_psnr"] = row.coordinate_psnr;
    }
    return json;
}

}  // namespace

std::vector<PrecisionBench> bench_precision(int repeats, std::size_t side) {
    std::vector<PrecisionBench> rows;
    for (const char* preset : {"wood", "marble"}) {
        const std::shared_ptr<Pipeline> pipeline = torus_with(preset, side);
        const std::size_t begin = rows.size();
        const Filled exact = fill(*pipeline, parse_precision("float64"));
        for (const std::string& name : precisions())
            rows.push_back(measured(preset, name, *pipeline, exact));
        add_times(rows, pipeline, begin, repeats);
    }
    return rows;
}

void run_precision_bench(const BenchCommand& command) {
    const std::vector<PrecisionBench> rows = bench_precision(command.repeats, command.size_or(512));
    if (!report_rows(command, rows, precision_json)) return;
    fmt::print("{:<8} {:<11} {:>10} {:>10} {:>7} {:>9}   {}\n", "texture", "precision", "max error",
               "RMS error", "PSNR", "ns/texel", "coordinates alone: RMS, PSNR");
    for (const PrecisionBench& row : rows) {
        fmt::print("{:<8} {:<11} {:>10.3g} {:>10.3g} {:>7.2f} {:>9.1f}", row.texture, row.precision,
                   row.max_error, row.rms_error, row.psnr, row.time.ns_per_unit());
        if (row.coordinate_rms_error > 0.0)
            fmt::print(" {:>10.3g} {:>7.2f}", row.coordinate_rms_error, row.coordinate_psnr);
        fmt::print("\n");
    }
}

}  // namespace burl
